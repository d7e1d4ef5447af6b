// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's header: a log that nobody reads.
#ifndef OROFORGE_MODEL_LOGGER_HPP
#define OROFORGE_MODEL_LOGGER_HPP

#include <rtt/os/fosi.h>

namespace RTT {

enum LoggerLevel { Never = 0, Fatal = 1, Critical = 2, Error = 3, Warning = 4, Info = 5, Debug = 6, RealTime = 7 };

struct NoLog {
    template <class T>
    const NoLog& operator<<(const T&) const {
        return *this;
    }
};
struct Logger {
    struct In {
        explicit In(const char*) {}
    };
};
inline NoLog log(LoggerLevel) { return {}; }
inline NoLog endlog() { return {}; }

}  // namespace RTT
#endif
