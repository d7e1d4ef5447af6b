// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_INTERNAL_DETAIL_ACTION_SLOT_HPP
#define RTT_INTERNAL_DETAIL_ACTION_SLOT_HPP

#include <rtt/base/ActionInterface.hpp>
#include <rtt/base/DataSourceBase.hpp>
#include <rtt/internal/SignalBase.hpp>
#include <rtt/internal/engine/engine_gate.hpp>

#include <memory>
#include <vector>

namespace RTT {
namespace internal {
namespace detail {

/** Connects an action to a signal whose signature is not known here. See OperationInterfacePart::produceSignal(). */
class ActionSlot final : public SignalBase::Connection {
public:
    typedef std::vector<base::DataSourceBase::shared_ptr> Sources;

    /** Owns `action`, which may be null; the types of the variables have been checked. */
    ActionSlot(base::ActionInterface* action, const Sources& variables, ExecutionEngine* subscriber);
    void call(void* const* arguments) const override;

private:
    class Event;
    void assign(void* const* arguments) const;
    void run() const;

    const std::unique_ptr<base::ActionInterface> action_;
    const Sources variables_;
    const boost::intrusive_ptr<const EngineGate> subscriber_;  // null: the emitting thread executes
};

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
