// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How a line that is being typed could go on.
#ifndef OROFORGE_CONSOLE_COMPLETION_HPP
#define OROFORGE_CONSOLE_COMPLETION_HPP

#include <rtt/TaskContext.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace OCL::console {

struct Completion {
    std::size_t begin = 0;           ///< in the line, of what the words would replace
    std::vector<std::string> words;  ///< in alphabetical order
    /** What follows if there is one word: "." where it has members, " " where a command takes more. */
    std::string behind = {};

    /** What all words have in common. */
    std::string common() const;
    /** What can be added to the line, which was completed, without a choice. */
    std::string more(const std::string& line) const;
};

/** The words that begin with what stands at the end of the line. Commands only if `commandsToo`. */
Completion completionOf(RTT::TaskContext& context, const std::string& line, bool commandsToo);

}  // namespace OCL::console

#endif
