// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The texts of programs and state machines with the line they are at: `list` and `trace`.
#ifndef OROFORGE_CONSOLE_PROGRAM_LISTING_HPP
#define OROFORGE_CONSOLE_PROGRAM_LISTING_HPP

#include "screen.hpp"

#include <rtt/TaskContext.hpp>

#include <string>
#include <vector>

namespace OCL::console {

struct Scripted;

class ProgramListing {
public:
    /** Ten lines before line `around`, or the one it is at for 0, and ten after. False if there is none of that name. */
    bool list(Screen& screen, RTT::TaskContext& component, const std::string& name, int around);
    /** Twenty lines of what was listed last: from line `from`, or those that follow for 0. False if nothing was. */
    bool listMore(Screen& screen, RTT::TaskContext& component, int from);

    /** Lists it now, and in update() whenever it has come to another line. False if there is none of that name. */
    bool trace(Screen& screen, RTT::TaskContext& component, const std::string& name);
    void traceAll(Screen& screen, RTT::TaskContext& component);
    /** False if it was not traced. */
    bool untrace(RTT::TaskContext& component, const std::string& name);
    void untraceAll() { traced_.clear(); }
    void update(Screen& screen, RTT::TaskContext& component);

private:
    struct Traced {
        std::string component, name;
        int line;
    };
    void write(Screen& screen, const Scripted& program, int from, int until);

    std::string last_;
    int next_ = 1;
    std::vector<Traced> traced_;
};

}  // namespace OCL::console

#endif
