// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The typed lines, kept in a file.
#ifndef OROFORGE_CONSOLE_HISTORY_HPP
#define OROFORGE_CONSOLE_HISTORY_HPP

#include <string>
#include <vector>

namespace OCL::console {

/** $ORO_TB_HISTFILE, or .tb_history in the current directory or, if that cannot be written, in the home directory. */
std::string historyFile();

/** What the environment variable names, where "~/" is the home directory; empty if it is not set. */
std::string fileNamedBy(const char* variable);

/** The lines, oldest first, at most 1000 of them. The file has one per line. */
class History {
public:
    /** Reads the file; without a name, keeps no file. */
    explicit History(std::string file = std::string());

    const std::vector<std::string>& lines() const { return lines_; }
    /** Why the file cannot be written; empty if it can, or if there is no file. */
    std::string problem() const;
    /** Adds a line, and writes it to the file at once, so that it survives a crash. Drops a line, and returns false, if
        it is blank, "quit", or the same as the one before. */
    bool add(const std::string& line);

private:
    void rewrite() const;

    std::string file_;
    std::vector<std::string> lines_;
};

}  // namespace OCL::console

#endif
