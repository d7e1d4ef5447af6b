// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_SCHEMA_IDL_READER_HPP
#define OROFORGE_SCHEMA_IDL_READER_HPP

#include "idl_tokens.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace oroforge::schema {

/** Goes through the tokens of a text. Functions that return bool say false once there is an error: the first one. */
class IdlReader {
public:
    explicit IdlReader(std::vector<IdlToken> tokens) : tokens_(std::move(tokens)) {}

    const IdlToken& next() const { return tokens_[at_]; }
    IdlToken take() { return isEnd() ? tokens_[at_] : tokens_[at_++]; }
    bool isEnd() const { return next().kind == IdlToken::End; }
    bool is(std::string_view text) const { return next().text == text && !isEnd(); }
    /** Do two signs follow that touch: a shift? */
    bool isPair(char sign) const {
        if (next().text != std::string_view(&sign, 1)) return false;
        const std::string_view second = tokens_[at_ + 1].text;
        return second == next().text && second.data() == next().text.data() + 1;
    }
    /** Takes it if it is the next one. */
    bool accept(std::string_view text) {
        if (!is(text)) return false;
        ++at_;
        return true;
    }
    bool expect(std::string_view text) { return accept(text) || failAt("'" + std::string(text) + "'"); }
    /** A name without parts. One that begins with an underscore because it is a keyword is without it. */
    bool expectName(std::string& name);
    /** Annotations, such as "@unit(value=\"m\")". False if one of them changes what the bytes mean. */
    bool skipAnnotations();
    /** Up to a sign, but not those in brackets. */
    bool skipTo(std::string_view sign);

    bool fail(std::size_t line, const std::string& why) {
        if (why_.empty()) why_ = "line " + std::to_string(line) + ": " + why;
        return false;
    }
    bool fail(const std::string& why) { return fail(next().line, why); }
    bool failAt(const std::string& expected);
    bool failed() const { return !why_.empty(); }
    const std::string& why() const { return why_; }

    /** The bits of the last @bit_bound; 0 if there was none among the last annotations. */
    unsigned bitBound() const { return bitBound_; }

private:
    std::vector<IdlToken> tokens_;
    std::size_t at_ = 0;
    std::string why_;
    unsigned bitBound_ = 0;
};

/** Is this a word of the language? */
bool isIdlKeyword(std::string_view name);

}  // namespace oroforge::schema

#endif
