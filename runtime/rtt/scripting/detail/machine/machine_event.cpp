// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/machine/machine_event.hpp>

#include <rtt/ExecutionEngine.hpp>
#include <rtt/types/TypeInfo.hpp>

namespace RTT::scripting::detail {

namespace {

/** The connection that a signal calls. May outlive the machine and the event. */
class Listener final : public internal::SignalBase::Connection {
public:
    Listener(std::shared_ptr<EventQueue> queue, OperationEvent& event) : queue_(std::move(queue)), event_(event) {}
    void call(void* const* arguments) const override { queue_->called(event_, arguments); }

private:
    const std::shared_ptr<EventQueue> queue_;
    OperationEvent& event_;
};

}  // namespace

OperationEvent::OperationEvent(std::vector<Source> arguments, std::vector<ActionPtr> assign)
    : arguments_(std::move(arguments)), assign_(std::move(assign)) {
    for (Call& call : calls_) {
        call.event = this;
        for (const Source& argument : arguments_) call.arguments.emplace_back(argument->getTypeInfo()->buildValue());
    }
}

void OperationEvent::receive() {
    for (const ActionPtr& assign : assign_) {
        assign->readArguments();
        assign->execute();
    }
}

void OperationEvent::listenTo(internal::SignalBase& signal, std::shared_ptr<EventQueue> queue) {
    const auto listener = std::make_shared<Listener>(std::move(queue), *this);
    signal.add(listener, true);
    handle_ = std::make_unique<CleanupHandle>(Handle(listener));
}

OperationEvent::Call* OperationEvent::keep(void* const* arguments) {
    for (Call& call : calls_) {
        if (call.waits.load(std::memory_order_relaxed) || call.waits.exchange(true, std::memory_order_acquire))
            continue;
        for (std::size_t i = 0; i != call.arguments.size(); ++i) call.arguments[i]->assignValue(arguments[i]);
        return &call;
    }
    return nullptr;
}

void OperationEvent::hold(void* const* arguments) {
    for (std::size_t i = 0; i != arguments_.size(); ++i) arguments_[i]->assignValue(arguments[i]);
}

void OperationEvent::hold(Call& kept) {
    for (std::size_t i = 0; i != arguments_.size(); ++i)
        arguments_[i]->assignValue(kept.arguments[i]->getRawConstPointer());
    kept.waits.store(false, std::memory_order_release);
}

void EventQueue::called(OperationEvent& event, void* const* arguments) {
    const StateMachinePtr machine = machine_.lock();
    if (!machine) return;
    {
        const internal::EngineGate::Stand direct(gate_.get());
        if (direct && machine->react(event, arguments)) return;
    }
    if (OperationEvent::Call* const call = event.keep(arguments)) {
        call->next = last_.load();
        while (!last_.compare_exchange_weak(call->next, call)) {
        }
    } else {
        lost_.fetch_add(1);
    }
    ask();
}

/** Sends a message to take the calls. If it is refused, the component has failed for good, is gone, or takes them in
    its next step. */
void EventQueue::ask() {
    if (asked_.exchange(true)) return;
    self_ = shared_from_this();
    if (!ExecutionEngine::process(*gate_, this)) dispose();
}

void EventQueue::executeAndDispose() {
    const std::shared_ptr<EventQueue> self = std::move(self_);
    asked_ = false;
    if (const StateMachinePtr machine = machine_.lock()) machine->takeEvents();
}

void EventQueue::dispose() {
    const std::shared_ptr<EventQueue> self = std::move(self_);
    asked_ = false;
}

OperationEvent::Call* EventQueue::takeList() {
    OperationEvent::Call* last = last_.load(std::memory_order_relaxed) ? last_.exchange(nullptr) : nullptr;
    OperationEvent::Call* first = nullptr;
    while (last) {
        OperationEvent::Call* const before = last->next;
        last->next = first;
        first = last;
        last = before;
    }
    return first;
}

}  // namespace RTT::scripting::detail
