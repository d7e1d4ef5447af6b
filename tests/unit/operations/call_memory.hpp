// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_UNIT_OPERATIONS_CALL_MEMORY_HPP
#define OROFORGE_TESTS_UNIT_OPERATIONS_CALL_MEMORY_HPP

namespace oroforge::test {

/** How often operator new was called so far, by all threads. */
unsigned long allocations();

}  // namespace oroforge::test

#endif
