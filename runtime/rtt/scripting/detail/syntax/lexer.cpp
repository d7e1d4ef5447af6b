// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/syntax/lexer.hpp>

#include <algorithm>

namespace RTT::scripting::detail {

namespace {

// Not from <cctype>, which depends on the locale.
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isWordLetter(char c) { return isLetter(c) || isDigit(c) || c == '_'; }
bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }
bool isTypeLetter(char c) { return isWordLetter(c) || std::string_view("-/<>.[]").find(c) != std::string_view::npos; }

/** A longer text with '<' and '>' is not the name of a type but many comparisons. */
constexpr std::size_t kMaxTemplate = 200;

}  // namespace

Lexer::Lexer(std::string_view text) : text_(text) {
    if (text_.substr(0, 3) == "\xEF\xBB\xBF") at_ = line_start_ = 3;
}

Token Lexer::take(TokenKind kind, std::size_t end) {
    Token token;
    token.kind = kind;
    token.newLine = new_line_;
    token.line = line_;
    token.column = static_cast<unsigned>(at_ - line_start_) + 1;
    token.begin = at_;
    token.end = end;
    at_ = end;
    new_line_ = false;
    return token;
}

Token Lexer::next() {
    if (!skipBlanks()) return take(TokenKind::OpenComment, text_.size());
    if (at_ == text_.size()) return take(TokenKind::End, at_);
    const char c = text_[at_];
    if (isLetter(c) || c == '_') return word();
    if (isDigit(c) || (c == '.' && isDigit(at(at_ + 1)))) return take(TokenKind::Number, endOfNumber(at_));
    if (c == '"' || c == '\'') return quoted(c);
    return punctuation();
}

/** Skips blanks and comments; false at a comment that does not end. */
bool Lexer::skipBlanks() {
    while (at_ < text_.size()) {
        const char c = text_[at_];
        if (c == '\n') {
            line_start_ = ++at_;
            ++line_;
            new_line_ = true;
        } else if (isBlank(c)) {
            ++at_;
        } else if (c == '#' || (c == '/' && at(at_ + 1) == '/')) {
            skipLine();
        } else if (c == '/' && at(at_ + 1) == '*') {
            if (!skipComment()) return false;
        } else {
            break;
        }
    }
    return true;
}

void Lexer::skipLine() { at_ = std::min(text_.find('\n', at_), text_.size()); }

bool Lexer::skipComment() {
    const std::size_t end = text_.find("*/", at_ + 2);
    if (end == std::string_view::npos) return false;
    for (; at_ < end + 2; ++at_) {
        if (text_[at_] != '\n') continue;
        line_start_ = at_ + 1;
        ++line_;
        new_line_ = true;
    }
    return true;
}

std::size_t Lexer::endOfWord(std::size_t from) const {
    while (isWordLetter(at(from))) ++from;
    return from;
}

/** The end of `<double>` if '(' follows; otherwise `from`. */
std::size_t Lexer::endOfTemplate(std::size_t from) const {
    if (at(from) != '<' || !(isLetter(at(from + 1)) || at(from + 1) == '/')) return from;
    unsigned depth = 0;
    for (std::size_t i = from; i < from + kMaxTemplate; ++i) {
        const char c = at(i);
        if (!(isTypeLetter(c) || c == ',' || c == ':') || (c == '/' && (at(i + 1) == '/' || at(i + 1) == '*'))) break;
        depth += c == '<';
        if (c != '>' || --depth != 0) continue;
        if (at(i + 1) == '[' && at(i + 2) == ']') i += 2;
        return at(i + 1) == '(' ? i + 1 : from;
    }
    return from;
}

Token Lexer::word() {
    const std::size_t end = endOfWord(at_);
    if (at(end) == '[' && at(end + 1) == ']') return take(TokenKind::TypeWord, end + 2);
    const std::size_t templateEnd = endOfTemplate(end);
    return take(templateEnd == end ? TokenKind::Word : TokenKind::TypeWord, templateEnd);
}

std::size_t Lexer::endOfTypeName(std::size_t from) const {
    while (true) {
        const char c = at(from);
        const bool comment = c == '/' && (at(from + 1) == '/' || at(from + 1) == '*');
        if (isTypeLetter(c) && !comment) {
            ++from;
        } else if (c == ':' && at(from + 1) == ':') {
            from += 2;
        } else {
            return from;
        }
    }
}

Token Lexer::typeName(const Token& token) {
    at_ = token.begin;
    line_ = token.line;
    line_start_ = token.begin - (token.column - 1);
    new_line_ = token.newLine;
    const char c = at(at_);
    const bool begins = isLetter(c) || c == '_' || c == '/';
    return take(TokenKind::TypeWord, begins ? endOfTypeName(at_) : at_);
}

/** The end of a number with all following letters, which need not be a valid suffix. */
std::size_t Lexer::endOfNumber(std::size_t from) const {
    if (at(from) == '0' && (at(from + 1) == 'x' || at(from + 1) == 'X')) return endOfWord(from);
    while (isDigit(at(from))) ++from;
    if (at(from) == '.') ++from;
    while (isDigit(at(from))) ++from;
    if (at(from) == 'e' || at(from) == 'E') {
        const bool sign = at(from + 1) == '+' || at(from + 1) == '-';
        if (isDigit(at(from + 1 + sign))) from += 1 + sign;
    }
    return endOfWord(from);
}

Token Lexer::quoted(char quote) {
    for (std::size_t i = at_ + 1; i < text_.size() && text_[i] != '\n'; ++i) {
        if (text_[i] == quote) return take(quote == '"' ? TokenKind::Text : TokenKind::Letter, i + 1);
        if (text_[i] == '\\' && at(i + 1) != '\n') ++i;
    }
    return take(TokenKind::OpenText, std::min(text_.find('\n', at_), text_.size()));
}

Token Lexer::punctuation() {
    const auto one = [this](TokenKind kind) { return take(kind, at_ + 1); };
    const auto orTwo = [this](TokenKind kind, char second, TokenKind both) {
        return at(at_ + 1) == second ? take(both, at_ + 2) : take(kind, at_ + 1);
    };
    switch (text_[at_]) {
        case '(': return one(TokenKind::OpenParen);
        case ')': return one(TokenKind::CloseParen);
        case '[': return one(TokenKind::OpenBracket);
        case ']': return one(TokenKind::CloseBracket);
        case '{': return one(TokenKind::OpenBrace);
        case '}': return one(TokenKind::CloseBrace);
        case ',': return one(TokenKind::Comma);
        case ';': return one(TokenKind::Semicolon);
        case '.': return one(TokenKind::Dot);
        case '+': return one(TokenKind::Plus);
        case '-': return one(TokenKind::Minus);
        case '*': return one(TokenKind::Times);
        case '/': return one(TokenKind::Divide);
        case '%': return one(TokenKind::Modulo);
        case ':': return orTwo(TokenKind::Colon, ':', TokenKind::Colon);
        case '=': return orTwo(TokenKind::Assign, '=', TokenKind::Equal);
        case '!': return orTwo(TokenKind::Not, '=', TokenKind::Unequal);
        case '<': return orTwo(TokenKind::Less, '=', TokenKind::LessEqual);
        case '>': return orTwo(TokenKind::Greater, '=', TokenKind::GreaterEqual);
        case '&': return orTwo(TokenKind::Stray, '&', TokenKind::And);
        case '|': return orTwo(TokenKind::Stray, '|', TokenKind::Or);
        default: return take(TokenKind::Stray, endOfStray(at_));
    }
}

/** The end of one stray byte, or of a row of bytes that are not ASCII. */
std::size_t Lexer::endOfStray(std::size_t from) const {
    const auto foreign = [this](std::size_t i) { return (static_cast<unsigned char>(at(i)) & 0x80U) != 0; };
    if (!foreign(from)) return from + 1;
    while (foreign(from)) ++from;
    return from;
}

}  // namespace RTT::scripting::detail
