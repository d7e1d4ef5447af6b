// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "idl_tokens.hpp"

#include <algorithm>
#include <cstdio>

namespace oroforge::schema {
namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isNamePart(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || isDigit(c); }

class IdlTokens {
public:
    IdlTokens(std::string_view text, std::vector<IdlToken>& tokens) : text_(text), tokens_(tokens) {}

    bool read(std::string& why) {
        while (skip())
            if (!readOne()) break;
        tokens_.push_back({IdlToken::End, {}, line_});
        if (wrong_.empty()) return true;
        why = "line " + std::to_string(line_) + ": " + wrong_;
        return false;
    }

private:
    bool startsWith(std::string_view what) const { return text_.substr(at_, what.size()) == what; }

    void skipTo(std::size_t end) {
        end = std::min(end, text_.size());
        line_ += static_cast<std::size_t>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                                     text_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
        at_ = end;
    }

    /** What is not a token. False at the end, and if a comment has none. */
    bool skip() {
        while (at_ != text_.size()) {
            const bool isLineStart = at_ == 0 || text_[at_ - 1] == '\n';
            if (isBlank(text_[at_])) {
                skipTo(at_ + 1);
            } else if (startsWith("/*")) {
                const std::size_t end = text_.find("*/", at_ + 2);
                if (end == std::string_view::npos) {
                    wrong_ = "the comment has no end";
                    return false;
                }
                skipTo(end + 2);
            } else if (startsWith("//") || text_[at_] == '#' ||
                       (isLineStart && (startsWith("===") || startsWith("IDL:")))) {
                skipTo(text_.find('\n', at_));
            } else {
                return true;
            }
        }
        return false;
    }

    bool readOne() {
        const char first = text_[at_];
        std::size_t end = at_ + 1;
        IdlToken token{IdlToken::Sign, {}, line_};
        if (isDigit(first) || (first == '.' && end != text_.size() && isDigit(text_[end]))) {
            token.kind = IdlToken::Number;
            const auto isPart = [this](std::size_t at) {
                const bool isExponent = (text_[at] == '+' || text_[at] == '-') && !startsWith("0x") &&
                                        (text_[at - 1] == 'e' || text_[at - 1] == 'E');
                return isNamePart(text_[at]) || text_[at] == '.' || isExponent;
            };
            while (end != text_.size() && isPart(end)) ++end;
        } else if (isNamePart(first) || startsWith("::")) {
            token.kind = IdlToken::Name;
            end = nameEnd();
            if (end == at_) return fail("found '::', expected a name behind it");
        } else if (first == '"' || first == '\'') {
            token.kind = first == '"' ? IdlToken::Text : IdlToken::Character;
            while (end < text_.size() && text_[end] != first && text_[end] != '\n') end += text_[end] == '\\' ? 2 : 1;
            if (end >= text_.size() || text_[end] != first) return fail("the text has no quotation mark at its end");
            ++end;
        } else if (std::string_view("{}[]()<>;:,=@+-*/%|&^~").find(first) == std::string_view::npos) {
            char shown[16];
            const auto code = static_cast<unsigned>(static_cast<unsigned char>(first));
            (void)std::snprintf(shown, sizeof shown, first > ' ' ? "'%c'" : "byte 0x%02x", code);
            return fail("found " + std::string(shown) + ", which is not part of IDL");
        }
        token.text = text_.substr(at_, end - at_);
        tokens_.push_back(token);
        at_ = end;
        return true;
    }

    /** "a", "::a", "a::b". */
    std::size_t nameEnd() const {
        std::size_t end = at_;
        for (std::size_t at = at_;;) {
            if (at != at_ || text_.substr(at, 2) == "::") {
                if (text_.substr(at, 2) != "::") return end;
                at += 2;
            }
            const std::size_t begin = at;
            while (at != text_.size() && isNamePart(text_[at])) ++at;
            if (at == begin) return end;
            end = at;
        }
    }

    bool fail(std::string why) {
        wrong_ = std::move(why);
        return false;
    }

    const std::string_view text_;
    std::vector<IdlToken>& tokens_;
    std::size_t at_ = 0, line_ = 1;
    std::string wrong_;
};

}  // namespace

bool readTokens(std::string_view text, std::vector<IdlToken>& tokens, std::string& why) {
    return IdlTokens(text, tokens).read(why);
}

}  // namespace oroforge::schema
