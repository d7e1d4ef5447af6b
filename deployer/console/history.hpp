// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What was typed, kept in a file across sessions.
#ifndef OROFORGE_CONSOLE_HISTORY_HPP
#define OROFORGE_CONSOLE_HISTORY_HPP

#include <string>
#include <vector>

namespace OCL::console {

/** $ORO_TB_HISTFILE, or .tb_history in the present directory or, where that cannot be written, in the home directory. */
std::string historyFile();

/** The lines, oldest first, at most 1000 of them. The file has one per line. */
class History {
public:
    /** Reads the file; an empty name is none. */
    explicit History(std::string file = std::string());

    const std::vector<std::string>& lines() const { return lines_; }
    /** Why the file cannot be written; empty if it can, or there is none. */
    std::string problem() const;
    /** At once into the file as well, so that it is not lost if the program ends by force. False if it was not taken: it is blank,
        "quit", or the same as the one before. */
    bool add(const std::string& line);

private:
    void rewrite() const;

    std::string file_;
    std::vector<std::string> lines_;
};

}  // namespace OCL::console

#endif
