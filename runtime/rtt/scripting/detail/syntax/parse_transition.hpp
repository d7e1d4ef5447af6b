// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_PARSE_TRANSITION_HPP
#define ORO_SCRIPTING_DETAIL_PARSE_TRANSITION_HPP

#include <rtt/scripting/detail/syntax/parse_rules.hpp>

namespace RTT::scripting::detail {

class TransitionParser : private Rules {
public:
    explicit TransitionParser(Grammar& grammar) : Rules(grammar) {}

    /** `transition …`, `transitions { … }`. */
    void parse(std::vector<ast::Transition>& to);
    /** `select A or B`, `{ … } select A`, `{ … }`. */
    ast::Selection selection();

private:
    ast::Transition transition();
    void event(ast::Transition& transition);
};

}  // namespace RTT::scripting::detail

#endif
