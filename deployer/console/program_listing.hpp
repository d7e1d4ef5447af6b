// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The commands `list` and `trace`: texts of programs and state machines, with the line where they are.
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
    /** Shows ten lines before and after line `around`; 0 means the line where it is. False if there is none of that
        name. */
    bool list(Screen& screen, RTT::TaskContext& component, const std::string& name, int around);
    /** Shows twenty more lines of the last listing, from line `from`; 0 means the lines that follow. False if there is
        none. */
    bool listMore(Screen& screen, RTT::TaskContext& component, int from);

    /** Lists it now, and in update() whenever it has reached another line. False if there is none of that name. */
    bool trace(Screen& screen, RTT::TaskContext& component, const std::string& name);
    void traceAll(Screen& screen, RTT::TaskContext& component);
    /** Ends a trace; false if there was none. */
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
