// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Counts what this process asks of the kernel's futexes: futex_count.cpp takes the place of libc's syscall().
#ifndef OROFORGE_TESTS_UNIT_OPERATIONS_FUTEX_COUNT_HPP
#define OROFORGE_TESTS_UNIT_OPERATIONS_FUTEX_COUNT_HPP

namespace oroforge::test {

/** Wake-ups asked for since the start, by any thread. */
long futexWakes();
/** True from just before the system call in which it sleeps until just after. */
bool isAsleep(int tid);

}  // namespace oroforge::test

#endif
