// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_PARSE_LOOKAHEAD_HPP
#define ORO_SCRIPTING_DETAIL_PARSE_LOOKAHEAD_HPP

#include <rtt/scripting/detail/syntax/parse_tokens.hpp>

namespace RTT::scripting::detail {

/** Tells what begins or ends at the present token. Most keywords can also be names, so what follows matters. */
class Lookahead {
public:
    explicit Lookahead(const TokenReader& tokens) : tokens_(tokens) {}

    bool atDeclaration() const;
    /** True at the statement `break`. */
    bool atBreak() const;
    /** True at what can only be at the top level. */
    bool atDefinition() const;
    /** True at `function f`, `double f(` or `double f {`. */
    bool atFunction() const;
    bool atState() const;
    /** True at `entry {`, `transitions {`, `transition select S` and the like, which are not statements. */
    bool atStateItem() const;
    bool atTransitions() const;
    /** True at the keyword `select`. */
    bool atSelect() const;
    bool atSelection() const;

    // True at something that cannot be in a block, state machine or state, because a '}' is missing.
    bool blockEndsHere() const;
    bool machineEndsHere() const;
    bool stateEndsHere() const;
    void setInMachine(bool on) { in_machine_ = on; }

private:
    const TokenReader& tokens_;
    bool in_machine_ = false;
};

}  // namespace RTT::scripting::detail

#endif
