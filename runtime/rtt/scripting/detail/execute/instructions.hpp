// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Instructions other than arithmetic.
#ifndef ORO_SCRIPTING_DETAIL_INSTRUCTIONS_HPP
#define ORO_SCRIPTING_DETAIL_INSTRUCTIONS_HPP

#include <rtt/internal/DataSource.hpp>
#include <rtt/scripting/detail/execute/process.hpp>

namespace RTT::scripting::detail {
namespace instructions {

// The brackets name the members of Instruction that each one uses.

/** Ends a program or a function [none]. */
const Instruction* leave(const Instruction& self, Process& process);
const Instruction* yield(const Instruction& self, Process& process);
/** `nothing`. */
const Instruction* idle(const Instruction& self, Process& process);
/** [offset] */
const Instruction* jump(const Instruction& self, Process& process);
/** Jumps if the bool at `a` is false [a, offset]. */
const Instruction* jumpUnless(const Instruction& self, Process& process);
/** Jumps to the beginning of a loop [offset]. */
const Instruction* jumpBack(const Instruction& self, Process& process);
/** Enters the Activation `to`. */
const Instruction* enter(const Instruction& self, Process& process);
/** Evaluates the source `to`. */
const Instruction* evaluate(const Instruction& self, Process& process);
/** Executes the ActionInterface `to`. */
const Instruction* perform(const Instruction& self, Process& process);
/** Stores the seconds since the epoch in the double `to`. */
const Instruction* now(const Instruction& self, Process& process);
/** Evaluates the DataSource<SendStatus> `to`; yields, to be executed again, until it is not SendNotReady. */
const Instruction* await(const Instruction& self, Process& process);

/** Lets the TrackedSend `to` report the outcome of the next call that is sent; null for none. */
const Instruction* announce(const Instruction& self, Process& process);
/** Forgets the call in the LastSent `to`, because the script collects another one from now on. */
const Instruction* forgetSent(const Instruction& self, Process& process);

const Instruction* failEvaluation(Process& process);

/** Copies the value, of type T, of the DataSourceBase `a` to `to`. */
template <class T>
const Instruction* load(const Instruction& self, Process& process) {
    auto* const source = const_cast<base::DataSourceBase*>(static_cast<const base::DataSourceBase*>(self.a));
    if (!source->evaluate()) return failEvaluation(process);
    const void* const value = source->getRawConstPointer();
    if (!value) return failEvaluation(process);
    *static_cast<T*>(self.to) = *static_cast<const T*>(value);
    return process.proceed(&self + 1);
}

/** Assigns the value at `a` to the AssignableDataSource<T> `to`. */
template <class T>
const Instruction* store(const Instruction& self, Process&) {
    static_cast<internal::AssignableDataSource<T>*>(self.to)->set(*static_cast<const T*>(self.a));
    return &self + 1;
}

}  // namespace instructions
}  // namespace RTT::scripting::detail

#endif
