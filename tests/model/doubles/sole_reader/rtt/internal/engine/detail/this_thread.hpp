// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's header: the threads of the checker.
#ifndef OROFORGE_MODEL_THIS_THREAD_HPP
#define OROFORGE_MODEL_THIS_THREAD_HPP

#include <model/checker/checker.hpp>

namespace RTT {
namespace internal {
namespace detail {

inline const char threads[8] = {};
inline const void* thisThread() { return &threads[model::self()]; }

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
