// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What all rules of the grammar need: the present token, what is said when it does not fit, and where to go on then.
#ifndef ORO_SCRIPTING_DETAIL_PARSE_TOKENS_HPP
#define ORO_SCRIPTING_DETAIL_PARSE_TOKENS_HPP

#include <rtt/scripting/detail/syntax/ast.hpp>
#include <rtt/scripting/detail/syntax/lexer.hpp>
#include <rtt/scripting/detail/syntax/token.hpp>

#include <diag/sink.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace RTT::scripting::detail {

/** True for words that cannot be names. */
bool isReserved(std::string_view word);

/**
 * Reads tokens. After an error it has *failed*: then no token matches and nothing more is reported, so that the rules come
 * to their ends, until a list of statements (or the like) goes on behind the error with recover().
 * A loop over tokens must therefore end when failed().
 */
class TokenReader {
protected:
    TokenReader(std::string_view text, const oroforge::diag::FileName& name, oroforge::diag::Sink& sink);

    bool failed() const { return failed_; }
    /** The present token, whether or not it failed. */
    const Token& token() const { return token_; }
    ast::Place place() const { return {token_.line, token_.column}; }
    /** Where the last letter of the token before the present one is, and the byte behind it. */
    ast::Place lastPlace() const;
    std::size_t lastEnd() const { return previous_.end; }
    /** The token before the present one is of the same kind. */
    bool repeated() const { return previous_.end != 0 && previous_.kind == token_.kind; }
    std::string_view text() const { return lexer_.text(token_); }
    std::string_view text(const Token& token) const { return lexer_.text(token); }

    bool at(TokenKind kind) const { return !failed_ && token_.kind == kind; }
    bool atWord(std::string_view word) const { return at(TokenKind::Word) && text() == word; }
    /** At a word that can be a name. */
    bool atName() const { return at(TokenKind::Word) && !isReserved(text()); }
    /** At a newline, ';', '}' or the end. */
    bool atStatementEnd() const;
    /** The token behind the present one. */
    Token following() const;
    /** At this word, with a name behind it: `program p`, but not `program.start()`. */
    bool atWordBeforeName(std::string_view word) const;

    /** A name, the name of a type, or what somebody took for a name: a reserved word, a number. */
    bool standsAsName(const Token& token) const;

    void advance();
    bool accept(TokenKind kind);
    bool acceptWord(std::string_view word);
    /** Fails if it is not there: "expected <what>". */
    bool expect(TokenKind kind, const char* what);
    /** Fails if it is not there. */
    bool expectWord(const char* word);
    /** The ')' or ']' of what was opened at `open`. */
    bool expectClosing(TokenKind kind, const char* what, const Token& open);
    /** Fails if the present token is none: "expected <what>". */
    ast::Identifier name(const char* what);
    ast::Identifier typeName();
    /** Goes back to the first letter of the present token and reads it as the name of a type. */
    Token tokenAsType(Lexer& lexer) const { return lexer.typeName(token_); }
    Lexer lexerHere() const { return lexer_; }
    /** Fails if there is something else on the line, and returns what it reported. A block needs no end. */
    oroforge::diag::Diagnostic* endStatement();
    /** The same, but leaves the ';' where it is. */
    oroforge::diag::Diagnostic* requireEnd();

    /** What the present token is called in messages. */
    std::string found() const;
    /** "found …, expected <what>", and fails. Null if it has failed before. */
    oroforge::diag::Diagnostic* fail(const std::string& expected, const char* code = "OPS001");
    /** As fail(), where something new begins: never says that a line ends too early. */
    oroforge::diag::Diagnostic* failHere(const std::string& expected);
    /** As fail(), if the error is in the present token itself. */
    oroforge::diag::Diagnostic* failWith(const char* code, std::string message);
    /** Reports, but does not fail. */
    oroforge::diag::Diagnostic& report(ast::Place at, const char* code, std::string message);
    oroforge::diag::Diagnostic& warn(ast::Place at, const char* code, std::string message);
    oroforge::diag::Location location(ast::Place at) const { return {name_, at.line, at.column}; }

    /** Fails, but reports nothing. */
    void giveUp() { failed_ = true; }

    /** A new statement begins here. */
    void beginStatement() { open_parens_ = 0; }
    /** If failed: goes to the end of the statement that began at byte `begin`; `else` and `catch` end it or belong to it. */
    void recover(std::size_t begin, bool elseEnds = false);
    /** Goes on here after an error, as if the token that is missing were there. */
    void forget() { failed_ = false; }
    /** If failed in what stands before a '{': goes there if it is on this line or begins the next. */
    void recoverAtBrace(bool acrossSemicolons = false);

private:
    oroforge::diag::Diagnostic* failAt(ast::Place at, const char* code, std::string message);
    bool reportLexical();
    bool closesSoon() const;
    void skipToClosing();

    Lexer lexer_;
    Token token_, previous_;
    bool failed_ = false;
    bool reported_end_ = false;
    std::size_t reported_at_ = ~std::size_t{0};  // the token in which the last error was
    int open_parens_ = 0;                        // since the beginning of the statement
    oroforge::diag::FileName name_;
    oroforge::diag::Sink& sink_;
};

}  // namespace RTT::scripting::detail

#endif
