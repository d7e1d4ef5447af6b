// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What all rules of the grammar need: the present token, errors for unexpected tokens, and recovery.
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
 * Reads tokens. After an error it has *failed*: no token matches and nothing more is reported, so that all rules end,
 * until a list of statements (or the like) continues after the error with recover(). A loop over tokens must therefore
 * end when failed().
 */
class TokenReader {
public:
    TokenReader(std::string_view text, const oroforge::diag::FileName& name, oroforge::diag::Sink& sink);

    bool failed() const { return failed_; }
    /** The present token, whether or not it failed. */
    const Token& token() const { return token_; }
    ast::Place place() const { return {token_.line, token_.column}; }
    /** The place of the last letter of the previous token, and the byte after it. */
    ast::Place lastPlace() const;
    std::size_t lastEnd() const { return previous_.end; }
    /** True if the previous token is of the same kind. */
    bool repeated() const { return previous_.end != 0 && previous_.kind == token_.kind; }
    std::string_view text() const { return lexer_.text(token_); }
    std::string_view text(const Token& token) const { return lexer_.text(token); }

    bool at(TokenKind kind) const { return !failed_ && token_.kind == kind; }
    bool atWord(std::string_view word) const { return at(TokenKind::Word) && text() == word; }
    /** True at a word that can be a name. */
    bool atName() const { return at(TokenKind::Word) && !isReserved(text()); }
    /** True at a newline, ';', '}' or the end. */
    bool atStatementEnd() const;
    /** The next token. */
    Token following() const;
    /** True at this word before a name: `program p`, but not `program.start()`. */
    bool atWordBeforeName(std::string_view word) const;

    /** True for a name, also of a type, and for what users may take for a name: a reserved word or a number. */
    bool standsAsName(const Token& token) const;

    void advance();
    bool accept(TokenKind kind);
    bool acceptWord(std::string_view word);
    /** Accepts `else` and `catch`, which may be on a new line and after a ';'. */
    bool acceptContinuation(std::string_view word);
    /** Accepts a token, or fails: "expected <what>". */
    bool expect(TokenKind kind, const char* what);
    /** Accepts this word, or fails. */
    bool expectWord(const char* word);
    /** Accepts the ')' or ']' for `open`, or fails. */
    bool expectClosing(TokenKind kind, const char* what, const Token& open);
    /** Accepts a name, or fails: "expected <what>". */
    ast::Identifier name(const char* what);
    ast::Identifier typeName();
    Lexer lexerHere() const { return lexer_; }
    /** Accepts the end of a statement. If the line goes on, fails and returns the report. A block needs no end. */
    oroforge::diag::Diagnostic* endStatement();
    /** The same, but leaves the ';' where it is. */
    oroforge::diag::Diagnostic* requireEnd();

    /** The description of the present token in messages. */
    std::string found() const;
    /** Reports "found …, expected <what>" and fails. Null if it has failed already. */
    oroforge::diag::Diagnostic* fail(const std::string& expected, const char* code = "OPS001");
    /** As fail(), but never says that a line ends too early, because something new begins here. */
    oroforge::diag::Diagnostic* failHere(const std::string& expected);
    /** As fail(), for an error in the present token itself. */
    oroforge::diag::Diagnostic* failWith(const char* code, std::string message);
    /** Reports an error without failing. */
    oroforge::diag::Diagnostic& report(ast::Place at, const char* code, std::string message);
    oroforge::diag::Diagnostic& warn(ast::Place at, const char* code, std::string message);
    oroforge::diag::Location location(ast::Place at) const { return {name_, at.line, at.column}; }

    /** Fails without a report. */
    void giveUp() { failed_ = true; }

    /** Begins a statement. */
    void beginStatement() { open_parens_ = 0; }
    /** If failed: skips to the end of the statement that began at byte `begin`; `else` and `catch` end it or belong to
        it. */
    void recover(std::size_t begin, bool elseEnds = false);
    /** Continues here after an error, as if the missing token were there. */
    void forget() { failed_ = false; }
    /** If failed before a '{': skips to it if it is on this line or begins the next. */
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
