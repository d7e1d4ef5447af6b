// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_OS_DETAIL_THREAD_LIST_HPP
#define RTT_OS_DETAIL_THREAD_LIST_HPP

namespace RTT {
namespace os {
namespace detail {

/** Adds a thread to os::threads; returns the smallest free number. */
int addThread(const char* name, unsigned pid);
void removeThread(int number);

}  // namespace detail
}  // namespace os
}  // namespace RTT
#endif
