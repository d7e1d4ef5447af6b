// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_SERVING_HPP
#define ORO_CORBA_DETAIL_SERVING_HPP

#include <rtt/internal/engine/engine_gate.hpp>

#include <functional>
#include <optional>
#include <utility>

namespace RTT {
namespace corba {
namespace detail {

/** Has another thread execute `work`. This one executes the messages of its component meanwhile. Throws what `work`
    throws. */
void executeElsewhere(const std::function<void()>& work);

/** Has another thread execute `work`, and does not wait for it. `work` throws nothing. */
void executeAside(std::function<void()> work);

/**
 * Makes a call of another process, which blocks. Within a step of a component, another thread makes it, because the
 * other process may call back an operation that only the thread of the component executes.
 */
template <class Call>
auto whileServing(Call call) -> decltype(call()) {
    if (!internal::EngineGate::ofThisThread()) return call();
    std::optional<decltype(call())> result;
    executeElsewhere([&] { result.emplace(call()); });
    return std::move(*result);
}

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
