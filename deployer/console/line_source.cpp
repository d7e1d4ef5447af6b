// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "line_source.hpp"

#include <cerrno>

#include <poll.h>
#include <unistd.h>

namespace OCL::console {

Wake waitForInput(int input, int endsOn, int other, int milliseconds) {
    pollfd all[] = {
        {input, POLLIN, 0}, {endsOn, POLLIN, 0}, {other, POLLIN, 0}};  // poll() ignores negative descriptors
    const int ready = poll(all, 3, milliseconds);
    if (ready == 0) return Wake::Time;
    if (ready < 0) return errno == EINTR ? Wake::Signal : Wake::End;
    if (all[1].revents != 0) return Wake::End;
    return all[0].revents != 0 ? Wake::Input : Wake::Other;
}

bool isReadable(int descriptor) { return waitForInput(-1, descriptor, -1, 0) == Wake::End; }

LineSource::Outcome InputLines::read(const std::string&, std::string& line) {
    if (isReadable(ends_on_)) return Outcome::End;  // lines that have arrived are not executed any more
    for (;;) {
        const std::size_t end = pending_.find('\n');
        if (end != std::string::npos) {
            line = pending_.substr(0, end);
            pending_.erase(0, end + 1);
            if (!line.empty() && line.back() == '\r') line.pop_back();
            return Outcome::Line;
        }
        if (at_end_) {
            line.swap(pending_);
            pending_.clear();
            return line.empty() ? Outcome::End : Outcome::Line;
        }
        const Wake woken = waitForInput(input_, ends_on_);
        if (woken == Wake::Signal) continue;
        if (woken == Wake::End) return Outcome::End;
        char block[4096];
        const ssize_t got = ::read(input_, block, sizeof block);
        if (got > 0)
            pending_.append(block, static_cast<std::size_t>(got));
        else if (got == 0 || errno != EINTR)
            at_end_ = true;
    }
}

}  // namespace OCL::console
