// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/calls/detail/action_slot.hpp>

#include <rtt/ExecutionEngine.hpp>
#include <rtt/types/TypeInfo.hpp>

namespace RTT::internal::detail {

/** One emission on its way to the subscriber's thread, with copies of its arguments. */
class ActionSlot::Event final : public base::DisposableInterface {
public:
    Event(std::shared_ptr<const Connection> slot, const Sources& variables, void* const* arguments)
        : slot_(std::move(slot)) {
        for (std::size_t i = 0; i != variables.size(); ++i) {
            copies_.push_back(variables[i]->getTypeInfo()->buildValue());
            copies_.back()->assignValue(arguments[i]);
        }
    }
    void executeAndDispose() override {
        const std::unique_ptr<Event> self(this);  // the action may throw
        if (!slot_->connected()) return;
        std::vector<void*> addresses;
        for (const auto& copy : copies_) addresses.push_back(copy->getRawPointer());
        slot().assign(addresses.data());
        slot().run();
    }
    void dispose() override { delete this; }

private:
    const ActionSlot& slot() const { return static_cast<const ActionSlot&>(*slot_); }

    std::shared_ptr<const Connection> slot_;
    Sources copies_;
};

ActionSlot::ActionSlot(base::ActionInterface* action, const Sources& variables, ExecutionEngine* subscriber)
    : action_(action), variables_(variables), subscriber_(subscriber ? subscriber->gate() : nullptr) {}

void ActionSlot::call(void* const* arguments) const {
    {
        const EngineGate::Stand direct(subscriber_.get());
        if (direct) {
            assign(arguments);
            run();
            return;
        }
    }
    // If refused, the subscriber has failed for good or is gone, and cannot react.
    auto event = std::make_unique<Event>(shared_from_this(), variables_, arguments);
    if (ExecutionEngine::process(*subscriber_, event.get())) (void)event.release();
}

void ActionSlot::assign(void* const* arguments) const {
    for (std::size_t i = 0; i != variables_.size(); ++i) {
        variables_[i]->assignValue(arguments[i]);
        variables_[i]->updated();
    }
}

void ActionSlot::run() const {
    if (!action_) return;
    action_->readArguments();
    action_->execute();
}

}  // namespace RTT::internal::detail
