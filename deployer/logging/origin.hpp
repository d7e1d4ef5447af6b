// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Which thread logs, for event_pool.cpp and LoggingEvent.cpp.
#ifndef OROFORGE_LOGGING_ORIGIN_HPP
#define OROFORGE_LOGGING_ORIGIN_HPP

namespace OCL::logging {

struct Origin {
    unsigned number;  ///< of this thread; 0 if it has none yet
    char name[16];    ///< as the system had it when the thread logged first
};

/** That of the calling thread. Allocates and locks nothing; the first call of a thread makes a system call. */
const Origin& origin() noexcept;

}  // namespace OCL::logging

#endif
