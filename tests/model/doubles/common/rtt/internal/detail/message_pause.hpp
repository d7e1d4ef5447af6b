// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's header: a pause in which there are no messages.
#ifndef OROFORGE_MODEL_MESSAGE_PAUSE_HPP
#define OROFORGE_MODEL_MESSAGE_PAUSE_HPP

#include <model/checker/checker.hpp>

#include <boost/function.hpp>

namespace RTT {
namespace internal {
namespace detail {

inline void pauseForMessages(const boost::function<bool()>&) { std::this_thread::yield(); }

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
