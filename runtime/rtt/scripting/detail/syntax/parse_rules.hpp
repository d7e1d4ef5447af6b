// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_PARSE_RULES_HPP
#define ORO_SCRIPTING_DETAIL_PARSE_RULES_HPP

#include <rtt/scripting/detail/syntax/parse_lookahead.hpp>

#include <memory>
#include <utility>

namespace RTT::scripting::detail {

struct Grammar;

/** The rules of the grammar for one subject. */
class Rules {
public:
    Rules(const Rules&) = delete;
    Rules& operator=(const Rules&) = delete;

protected:
    explicit Rules(Grammar& grammar);
    ~Rules() = default;

    Grammar& grammar_;
    TokenReader& tokens_;
    Lookahead& ahead_;
};

}  // namespace RTT::scripting::detail

#endif
