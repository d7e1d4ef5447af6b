// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_PARSE_NESTING_HPP
#define ORO_SCRIPTING_DETAIL_PARSE_NESTING_HPP

#include <rtt/scripting/detail/syntax/parse_tokens.hpp>
#include <rtt/scripting/detail/syntax/parser.hpp>

#include <string>
#include <utility>

namespace RTT::scripting::detail {

/** Limits how deep expressions and blocks are in each other. */
class Nesting {
public:
    explicit Nesting(TokenReader& tokens) : tokens_(tokens) {}

    /** One level of nesting, while it exists; false if that is too deep or reading has failed. */
    class Level {
    public:
        explicit Level(Nesting& nesting) : nesting_(nesting), ok_(nesting.enter()) {}
        Level(const Level&) = delete;
        Level& operator=(const Level&) = delete;
        ~Level() { --nesting_.level_; }
        explicit operator bool() const { return ok_; }

    private:
        Nesting& nesting_;
        bool ok_;
    };
    void beginItem() { reported_ = false; }
    /** Reports once per item, because enclosing expressions are too deep for the same reason. */
    void fail() {
        if (std::exchange(reported_, true)) return tokens_.giveUp();
        tokens_.failWith(
            "OPS010", "found expressions or blocks in each other more than " + std::to_string(kMaxNesting) + " deep");
    }

private:
    bool enter() {
        if (++level_ <= kMaxNesting) return !tokens_.failed();
        fail();
        return false;
    }

    TokenReader& tokens_;
    unsigned level_ = 0;
    bool reported_ = false;  // for the present item
};

}  // namespace RTT::scripting::detail

#endif
