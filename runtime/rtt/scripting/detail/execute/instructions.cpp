// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/execute/instructions.hpp>

#include <rtt/SendStatus.hpp>
#include <rtt/os/TimeService.hpp>
#include <rtt/scripting/detail/compile/tracked_send.hpp>
#include <rtt/types/refusal_watch.hpp>

namespace RTT::scripting::detail {
namespace instructions {

using types::detail::RefusalWatch;

const Instruction* leave(const Instruction&, Process& process) { return process.leave(); }

const Instruction* yield(const Instruction& self, Process& process) { return process.yieldTo(&self + 1); }
const Instruction* idle(const Instruction& self, Process& process) { return process.idleTo(&self + 1); }

const Instruction* jump(const Instruction& self, Process&) { return &self + self.offset; }

const Instruction* jumpUnless(const Instruction& self, Process&) {
    return *static_cast<const bool*>(self.a) ? &self + 1 : &self + self.offset;
}

const Instruction* jumpBack(const Instruction& self, Process& process) { return process.goRound(&self + self.offset); }

const Instruction* enter(const Instruction& self, Process& process) {
    return process.enter(*static_cast<Activation*>(self.to), &self + 1);
}

const Instruction* evaluate(const Instruction& self, Process& process) {
    if (!static_cast<base::DataSourceBase*>(self.to)->evaluate()) return failEvaluation(process);
    return process.proceed(&self + 1);
}

const Instruction* perform(const Instruction& self, Process& process) {
    auto* const action = static_cast<base::ActionInterface*>(self.to);
    action->readArguments();
    if (!action->execute())
        return process.fail(RefusalWatch::takeReason("there is no value to be assigned, or it does not fit"));
    return process.proceed(&self + 1);
}

const Instruction* now(const Instruction& self, Process&) {
    auto* const clock = os::TimeService::Instance();
    *static_cast<double*>(self.to) = static_cast<double>(clock->getNSecs()) * 1e-9;
    return &self + 1;
}

const Instruction* await(const Instruction& self, Process& process) {
    auto* const status = static_cast<internal::DataSource<SendStatus>*>(self.to);
    if (status->get() == SendNotReady) return process.idleTo(&self);
    return &self + 1;
}

const Instruction* announce(const Instruction& self, Process&) {
    auto* const told = static_cast<TrackedSend*>(self.to);
    internal::Sending::announce(told ? told->announcement() : internal::Sending());
    return &self + 1;
}

const Instruction* forgetSent(const Instruction& self, Process&) {
    static_cast<LastSent*>(self.to)->set(nullptr);
    return &self + 1;
}

const Instruction* failEvaluation(Process& process) {
    return process.fail(RefusalWatch::takeReason("an expression has no value, or a call was not accepted"));
}

}  // namespace instructions
}  // namespace RTT::scripting::detail
