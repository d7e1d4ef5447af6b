// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_PARSE_BRACES_HPP
#define ORO_SCRIPTING_DETAIL_PARSE_BRACES_HPP

#include <rtt/scripting/detail/syntax/parse_nesting.hpp>
#include <rtt/scripting/detail/syntax/parse_rules.hpp>

namespace RTT::scripting::detail {

/** Matches braces, and finds out where one is missing. */
class Braces : private Rules {
public:
    explicit Braces(Grammar& grammar);

    /** Parses the contents of braces, with `item` for each piece, up to '}' or to `endsHere`, where the '}' is missing.
        Returns the place of the '}'. */
    template <class Item>
    ast::Place contents(bool (Lookahead::*endsHere)() const, Item item) {
        Token open;
        const Nesting::Level level(nesting_);
        if (!level || !openBraces(open)) return tokens_.place();
        while (!tokens_.failed() && !tokens_.at(TokenKind::CloseBrace) && !tokens_.at(TokenKind::End) &&
               !(ahead_.*endsHere)()) {
            if (tokens_.accept(TokenKind::Semicolon)) continue;
            const std::size_t begin = tokens_.token().begin;
            tokens_.beginStatement();
            item();
            tokens_.recover(begin);
        }
        const ast::Place end = tokens_.place();
        closeBraces(open);
        return end;
    }
    /** Skips a '}' between the items of a script. */
    void skipStray();

private:
    bool openBraces(Token& open);
    void closeBraces(const Token& open);

    Nesting& nesting_;
    static constexpr std::size_t kNowhere = ~std::size_t{0};
    unsigned assumed_closed_ = 0;        // blocks whose '}' is missing, though it may come later
    std::size_t assumed_at_ = kNowhere;  // the token before which they end
};

}  // namespace RTT::scripting::detail

#endif
