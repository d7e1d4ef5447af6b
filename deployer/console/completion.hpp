// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Completes the line that is being typed.
#ifndef OROFORGE_CONSOLE_COMPLETION_HPP
#define OROFORGE_CONSOLE_COMPLETION_HPP

#include <rtt/TaskContext.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace OCL::console {

struct Completion {
    std::size_t begin = 0;           ///< where in the line the words go
    std::vector<std::string> words;  ///< in alphabetical order
    /** What follows if there is only one word: "." if it has members, " " if a command takes more. */
    std::string behind = {};

    /** The longest beginning that all words share. */
    std::string common() const;
    /** What can be added to the completed line without a choice. */
    std::string more(const std::string& line) const;
};

/** The words that begin with the end of the line. Includes commands if `commandsToo`. */
Completion completionOf(RTT::TaskContext& context, const std::string& line, bool commandsToo);

}  // namespace OCL::console

#endif
