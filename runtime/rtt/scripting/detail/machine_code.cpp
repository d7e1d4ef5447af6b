// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/machine_code.hpp>

#include <rtt/OperationInterfacePart.hpp>

#include <boost/weak_ptr.hpp>

namespace RTT {
namespace scripting {
namespace detail {

CodeRoutine::CodeRoutine(std::unique_ptr<const Code> code, oroforge::diag::FileName file, RoundLimit limit)
    : code_(std::move(code)), file_(std::move(file)), limit_(std::move(limit)), process_(*code_) {}

Routine::Outcome CodeRoutine::run() {
    limit();
    return process_.run();
}

Routine::Outcome CodeRoutine::runStatement() {
    limit();
    return process_.runStatement();
}

unsigned CodeRoutine::line() const {
    return process_.started() ? process_.line() : code_->placeOf(code_->begin()).line;
}

oroforge::diag::Location CodeRoutine::where() const {
    const ast::Place place = process_.place();
    return {file_, place.line, place.column};
}

CodeGuard::CodeGuard(std::unique_ptr<const Code> code, const bool* result, oroforge::diag::FileName file,
                     RoundLimit limit)
    : routine_(std::move(code), std::move(file), std::move(limit)), result_(result) {}

Guard::Truth CodeGuard::check(unsigned) {
    const Routine::Outcome outcome = routine_.run();
    if (outcome == Routine::Outcome::Finished) return *result_ ? Truth::Yes : Truth::No;
    yielded_ = outcome != Routine::Outcome::Failed;
    return Truth::Failed;
}

std::string CodeGuard::failure() const {
    return yielded_ ? "a condition has to be decided at once, but a function in it yields" : routine_.failure();
}

PortReader::PortReader(const base::InputPortInterface& port, base::DataSourceBase::shared_ptr sample)
    : name_(port.getName()), port_(port), sample_(std::move(sample)) {}

bool PortReader::hasNewData(unsigned round) {
    if (round_ != round) status_ = port_.read(sample_->getRawPointer());
    round_ = round;
    return status_ == NewData;
}

PortGuard::PortGuard(std::shared_ptr<PortReader> reader, ActionPtr assign, oroforge::diag::Location where)
    : reader_(std::move(reader)), assign_(std::move(assign)), where_(std::move(where)) {}

Guard::Truth PortGuard::check(unsigned round) {
    if (!reader_->hasNewData(round)) return Truth::No;
    if (!assign_) return Truth::Yes;
    assign_->readArguments();
    return assign_->execute() ? Truth::Yes : Truth::Failed;
}

std::string PortGuard::failure() const {
    return "the sample of port '" + reader_->name() + "' cannot be assigned to its variable";
}

/** Passes a call on to the machine, if that still exists. */
class EventAction final : public base::ActionInterface {
public:
    EventAction(const StateMachinePtr& machine, MachineEvent& event) : machine_(machine), event_(event) {}
    void readArguments() override {}
    bool execute() override {
        const StateMachinePtr machine = machine_.lock();
        return machine && machine->react(event_);
    }
    base::ActionInterface* clone() const override { return new EventAction(machine_.lock(), event_); }

private:
    const boost::weak_ptr<StateMachine> machine_;
    MachineEvent& event_;  // of the machine
};

OperationEvent::OperationEvent(std::vector<base::DataSourceBase::shared_ptr> arguments, std::vector<ActionPtr> assign)
    : arguments_(std::move(arguments)), assign_(std::move(assign)) {}

void OperationEvent::receive() {
    for (const ActionPtr& assign : assign_) {
        assign->readArguments();
        assign->execute();
    }
}

void OperationEvent::listenTo(const OperationInterfacePart& operation, const StateMachinePtr& machine,
                              ExecutionEngine* engine) {
    auto action = std::make_unique<EventAction>(machine, *this);
    const Handle handle = operation.produceSignal(action.get(), arguments_, engine);
    (void)action.release();
    handle_ = std::make_unique<CleanupHandle>(handle);
}

}  // namespace detail
}  // namespace scripting
}  // namespace RTT
