// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_WRITING_THREAD_HPP
#define ORO_OCL_REPORTING_WRITING_THREAD_HPP

#include <csignal>

namespace OCL::reporting {

/** Blocks the signals that a closed pipe or a file size limit would send to this thread: they would end the process
    with all other components, and write() returns an error anyway. */
inline void takeNoSignalsOfWriting() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGPIPE);
    sigaddset(&signals, SIGXFSZ);
    (void)pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

}  // namespace OCL::reporting

#endif
