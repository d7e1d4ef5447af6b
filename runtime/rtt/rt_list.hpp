// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_RT_LIST_HPP
#define ORO_RT_LIST_HPP

#include <rtt/os/oro_allocator.hpp>

#include <list>

namespace RTT {

/** A list with its nodes in real-time memory. Inserting throws std::bad_alloc when that is used up. */
template <class T>
using rt_list = std::list<T, os::rt_allocator<T>>;

}  // namespace RTT
#endif
