// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Measuring what a process can do only once, or what leaves traces in its memory.
#ifndef OROFORGE_BENCH_CHILD_HPP
#define OROFORGE_BENCH_CHILD_HPP

#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bench {

/** What `measure()` returns in a child process, whose memory nobody else has used before. */
template <class Measure>
double inChild(Measure measure) {
    int ends[2];
    double result = 0;
    if (pipe(ends) != 0) return 0;
    const pid_t child = fork();
    if (child == 0) {
        malloc_trim(0);
        result = measure();
        const bool sent = write(ends[1], &result, sizeof result) == sizeof result;
        _exit(sent ? 0 : 1);
    }
    close(ends[1]);
    if (child < 0 || read(ends[0], &result, sizeof result) != sizeof result) result = 0;
    close(ends[0]);
    if (child > 0) waitpid(child, nullptr, 0);
    return result;
}

}  // namespace bench

#endif
