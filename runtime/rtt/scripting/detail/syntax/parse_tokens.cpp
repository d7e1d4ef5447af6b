// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/syntax/parse_tokens.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <utility>

namespace RTT::scripting::detail {

namespace {

using oroforge::diag::Diagnostic;

constexpr std::string_view kReserved[] = {
    "alias", "and",   "call", "catch",   "collect", "collectIfDone", "const", "define",  "do",   "done",
    "else",  "false", "for",  "foreach", "if",      "include",       "not",   "nothing", "or",   "return",
    "send",  "set",   "then", "true",    "try",     "until",         "var",   "while",   "yield"};

/** A bit for each length that reserved words with the same first letter have. */
constexpr auto kLengths = [] {
    std::array<unsigned, 26> lengths{};
    for (const std::string_view word : kReserved) lengths[static_cast<std::size_t>(word[0] - 'a')] |= 1U << word.size();
    return lengths;
}();

/** The number of tokens to look ahead for a ')' after an error. */
constexpr int kLookAhead = 200;

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

/** The text, or its beginning if it is long. */
std::string shortened(std::string_view text) {
    constexpr std::size_t most = 24;
    if (text.size() <= most) return std::string(text);
    std::size_t end = most;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
    return std::string(text.substr(0, end)) + "…";
}

bool isUtf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const std::size_t size = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC2 ? 2 : 0;
        if (size == 0 || i + size > text.size() || lead > 0xF4) return false;
        for (std::size_t k = 1; k < size; ++k)
            if ((static_cast<unsigned char>(text[i + k]) & 0xC0U) != 0x80U) return false;
        i += size;
    }
    return true;
}

/** The first letter of a UTF-8 text. */
unsigned firstLetter(std::string_view text) {
    const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned lead = byte(0);
    unsigned letter = lead >= 0xF0 ? lead & 0x07U : lead >= 0xE0 ? lead & 0x0FU : lead & 0x1FU;
    for (std::size_t i = 1; i < text.size() && (byte(i) & 0xC0U) == 0x80U; ++i)
        letter = letter << 6U | (byte(i) & 0x3FU);
    return letter;
}

/** True for blanks that are not ASCII and for letters without width. */
bool isInvisible(unsigned letter) {
    return letter == 0xA0 || letter == 0xAD || (letter >= 0x2000 && letter <= 0x200F) ||
           (letter >= 0x2028 && letter <= 0x202F) || (letter >= 0x205F && letter <= 0x2064) || letter == 0x3000 ||
           letter == 0xFEFF;
}

/** A description of letters that are not ASCII. */
std::string strayLetters(std::string_view text) {
    const unsigned letter = firstLetter(text);
    if (isInvisible(letter)) {
        char number[8];
        std::snprintf(number, sizeof(number), "%04X", letter);
        return std::string("found the invisible letter U+") + number + ", expected a plain blank or nothing";
    }
    const bool isQuote = (letter >= 0x2018 && letter <= 0x201F) || letter == 0xAB || letter == 0xBB;
    return "found " + quoted(shortened(text)) + ", expected ASCII letters outside of texts and comments" +
           (isQuote ? "; put texts between plain quotes, \"…\"" : "");
}

std::string strayMessage(std::string_view text) {
    const auto byte = static_cast<unsigned char>(text[0]);
    if (byte < 0x80 && byte >= 0x20 && byte != 0x7F) {
        std::string message = "found " + quoted(text) + ", which has no meaning here";
        if (byte == '?') message += "; instead of 'x = a ? b : c' write 'if a then x = b else x = c'";
        if (byte == '&' || byte == '|') message += "; did you mean " + quoted(std::string(2, text[0])) + "?";
        return message;
    }
    if (byte >= 0x80 && isUtf8(text)) return strayLetters(text);
    static constexpr char digits[] = "0123456789abcdef";
    return std::string("found the byte 0x") + digits[byte >> 4] + digits[byte & 15] +
           ", which has no meaning in a script";
}

}  // namespace

bool isReserved(std::string_view word) {
    // Asked for almost every token, and most are names.
    if (word.empty() || word.size() > 31 || word[0] < 'a' || word[0] > 'z') return false;
    if ((kLengths[static_cast<std::size_t>(word[0] - 'a')] >> word.size() & 1U) == 0) return false;
    return std::find(std::begin(kReserved), std::end(kReserved), word) != std::end(kReserved);
}

TokenReader::TokenReader(std::string_view text, const oroforge::diag::FileName& name, oroforge::diag::Sink& sink)
    : lexer_(text), name_(name), sink_(sink) {
    token_ = lexer_.next();
}

ast::Place TokenReader::lastPlace() const {
    const std::size_t size = previous_.end - previous_.begin;
    return {previous_.line, previous_.column + static_cast<unsigned>(size == 0 ? 0 : size - 1)};
}

bool TokenReader::atStatementEnd() const {
    return token_.newLine || token_.kind == TokenKind::Semicolon || token_.kind == TokenKind::CloseBrace ||
           token_.kind == TokenKind::End;
}

Token TokenReader::following() const {
    Lexer ahead = lexer_;
    return ahead.next();
}

bool TokenReader::atWordBeforeName(std::string_view word) const {
    if (!atWord(word)) return false;
    return standsAsName(following());
}

bool TokenReader::standsAsName(const Token& token) const {
    if (token.kind == TokenKind::Number || token.kind == TokenKind::TypeWord) return !token.newLine;
    if (token.kind != TokenKind::Word) return false;
    if (!isReserved(text(token))) return true;
    for (const std::string_view word : {"and", "or", "then", "else", "catch"})
        if (text(token) == word) return false;
    return !token.newLine;
}

void TokenReader::advance() {
    open_parens_ += token_.kind == TokenKind::OpenParen || token_.kind == TokenKind::OpenBracket;
    open_parens_ -= token_.kind == TokenKind::CloseParen || token_.kind == TokenKind::CloseBracket;
    previous_ = token_;
    token_ = lexer_.next();
}

bool TokenReader::accept(TokenKind kind) {
    if (!at(kind)) return false;
    advance();
    return true;
}

bool TokenReader::acceptWord(std::string_view word) {
    if (!atWord(word)) return false;
    advance();
    return true;
}

bool TokenReader::acceptContinuation(std::string_view word) {
    if (at(TokenKind::Semicolon)) {
        const Token next = following();
        if (next.kind == TokenKind::Word && text(next) == word) advance();
    }
    return acceptWord(word);
}

bool TokenReader::expect(TokenKind kind, const char* what) {
    if (accept(kind)) return true;
    fail(what);
    return false;
}

bool TokenReader::expectWord(const char* word) {
    if (acceptWord(word)) return true;
    fail(quoted(word));
    return false;
}

bool TokenReader::expectClosing(TokenKind kind, const char* what, const Token& open) {
    if (accept(kind)) return true;
    Diagnostic* error = fail(what);
    if (error && open.line != token_.line) error->note(location({open.line, open.column}), "opened here");
    return false;
}

ast::Identifier TokenReader::name(const char* what) {
    ast::Identifier result;
    if (at(TokenKind::Word) && isReserved(text())) {
        failWith("OPS008", "found the reserved word " + quoted(text()) + ", expected " + what);
    } else if (!at(TokenKind::Word)) {
        fail(what);
    } else {
        result.text = std::string(text());
        result.at = place();
        advance();
    }
    return result;
}

ast::Identifier TokenReader::typeName() {
    ast::Identifier result;
    if (failed_) return result;
    Lexer lexer = lexer_;
    const Token type = lexer.typeName(token_);
    if (type.begin == type.end) {
        fail("the name of a type");
    } else if (token_.kind == TokenKind::Word && isReserved(text(type))) {
        failWith("OPS008", "found the reserved word " + quoted(text(type)) + ", expected the name of a type");
    } else {
        result.text = std::string(text(type));
        result.at = place();
        previous_ = type;
        token_ = lexer.next();
        lexer_ = lexer;
    }
    return result;
}

Diagnostic* TokenReader::endStatement() {
    Diagnostic* error = requireEnd();
    accept(TokenKind::Semicolon);
    return error;
}

Diagnostic* TokenReader::requireEnd() {
    if (failed_ || atStatementEnd()) return nullptr;
    // After an error, the ';' may have been skipped.
    if (previous_.kind == TokenKind::CloseBrace || previous_.kind == TokenKind::Semicolon) return nullptr;
    return fail("a new line or ';' at the end of the statement", "OPS002");
}

std::string TokenReader::found() const {
    switch (token_.kind) {
        case TokenKind::End: return "the end of the script";
        case TokenKind::Number: return shortened(text());
        case TokenKind::Text: return "the text " + shortened(text());
        case TokenKind::Letter: return "the letter " + std::string(text());
        case TokenKind::Word: return (isReserved(text()) ? "the reserved word " : "") + quoted(shortened(text()));
        default: return quoted(shortened(text()));
    }
}

Diagnostic* TokenReader::fail(const std::string& expected, const char* code) {
    if (failed_ || reportLexical()) return nullptr;
    // If a line or the script ends too early, the place is after its last token.
    const bool behind = (token_.newLine || token_.kind == TokenKind::End) && previous_.end != previous_.begin;
    const ast::Place last = lastPlace();
    const bool end = token_.kind == TokenKind::End;
    return failAt(behind ? ast::Place{last.line, last.column + 1} : place(), code,
                  "found " + (behind && !end ? "the end of the line" : found()) + ", expected " + expected);
}

Diagnostic* TokenReader::failHere(const std::string& expected) {
    if (token_.kind == TokenKind::End) return fail(expected);
    return failWith("OPS001", "found " + found() + ", expected " + expected);
}

Diagnostic* TokenReader::failWith(const char* code, std::string message) {
    if (failed_ || reportLexical()) return nullptr;
    return failAt(place(), code, std::move(message));
}

Diagnostic* TokenReader::failAt(ast::Place at, const char* code, std::string message) {
    failed_ = true;
    // At the end, all enclosing rules miss something, but only one may report it.
    const bool end = token_.kind == TokenKind::End || token_.kind == TokenKind::OpenComment;
    if (end && std::exchange(reported_end_, true)) return nullptr;
    if (std::exchange(reported_at_, token_.begin) == token_.begin) return nullptr;
    return &report(at, code, std::move(message));
}

/** Reports a malformed token. */
bool TokenReader::reportLexical() {
    if (token_.kind == TokenKind::Stray) {
        failAt(place(), "OPS003", strayMessage(text()));
    } else if (token_.kind == TokenKind::OpenText) {
        const std::string quote(text().substr(0, 1));
        failAt(place(), "OPS004",
               "found the end of the line, expected " + quote + " at the end of the " +
                   (quote == "\"" ? "text" : "letter"));
    } else if (token_.kind == TokenKind::OpenComment) {
        failAt(place(), "OPS005", "found the end of the script, expected '*/' at the end of the comment");
    } else {
        return false;
    }
    return true;
}

Diagnostic& TokenReader::report(ast::Place at, const char* code, std::string message) {
    return sink_.error(location(at), code, std::move(message));
}

Diagnostic& TokenReader::warn(ast::Place at, const char* code, std::string message) {
    return sink_.warning(location(at), code, std::move(message));
}

/** True if the open parentheses are closed within the statement. */
bool TokenReader::closesSoon() const {
    Lexer ahead = lexer_;
    Token next = token_;
    int open = open_parens_;
    bool separated = false;  // by the ';' of a `for`, which is on one line
    for (int i = 0; i < kLookAhead && open > 0; ++i, next = ahead.next()) {
        if (next.newLine && separated) return false;
        switch (next.kind) {
            case TokenKind::OpenParen:
            case TokenKind::OpenBracket: ++open; break;
            case TokenKind::CloseParen:
            case TokenKind::CloseBracket: --open; break;
            case TokenKind::Semicolon: separated = true; break;
            case TokenKind::OpenBrace:
            case TokenKind::CloseBrace:
            case TokenKind::OpenComment:
            case TokenKind::End: return false;
            default: break;
        }
    }
    return open <= 0;
}

void TokenReader::skipToClosing() {
    if (open_parens_ <= 0 || !closesSoon()) return;
    while (open_parens_ > 0) advance();
}

void TokenReader::recover(std::size_t begin, bool elseEnds) {
    if (!failed_) return;
    failed_ = false;
    skipToClosing();
    int depth = 0;
    bool blockEnded = false;
    while (token_.kind != TokenKind::End) {
        if (token_.kind == TokenKind::OpenComment) reportLexical();
        failed_ = false;
        const bool orElse = atWord("else") || atWord("catch");
        if (depth == 0 && orElse && elseEnds) break;
        if (depth == 0 && token_.begin != begin) {
            if (token_.kind == TokenKind::CloseBrace || accept(TokenKind::Semicolon)) break;
            const bool goesOn = token_.kind == TokenKind::OpenBrace || orElse;
            if ((token_.newLine || blockEnded) && !goesOn) break;
        }
        depth += token_.kind == TokenKind::OpenBrace;
        depth -= token_.kind == TokenKind::CloseBrace;
        blockEnded = token_.kind == TokenKind::CloseBrace;
        advance();
    }
}

void TokenReader::recoverAtBrace(bool acrossSemicolons) {
    if (!failed_ || (token_.newLine && token_.kind != TokenKind::OpenBrace)) return;
    Lexer ahead = lexer_;
    Token previous = previous_, next = token_;
    while (next.kind != TokenKind::OpenBrace) {
        previous = next;
        next = ahead.next();
        const bool ends = next.newLine && next.kind != TokenKind::OpenBrace;
        const bool separates = next.kind == TokenKind::Semicolon && !acrossSemicolons;
        if (ends || separates || next.kind == TokenKind::CloseBrace || next.kind == TokenKind::End) return;
    }
    failed_ = false;
    previous_ = previous;
    token_ = next;
    lexer_ = ahead;
    open_parens_ = 0;
}

}  // namespace RTT::scripting::detail
