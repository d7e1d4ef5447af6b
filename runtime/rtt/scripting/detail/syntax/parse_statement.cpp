// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/syntax/parse_rules.hpp>

#include <diag/nearest_match.hpp>

namespace RTT::scripting::detail {

namespace {

std::string pathOf(const ast::Name& name) {
    std::string path;
    for (const ast::Identifier& part : name.parts) path += (path.empty() ? "" : ".") + part.text;
    return path;
}

/** The keyword that `word` resembles: before a literal one that takes a value, before a block one that has a block. */
std::string meantKeyword(const std::string& word, bool beforeLiteral, bool beforeBlock) {
    if (word.size() < 3) return word == "If" || word == "IF" ? "; did you mean 'if'?" : "";
    if (word == "import" || word == "require" || word == "select") return "";
    if (word == "elsif" || word == "elseif" || word == "elif") return "; write 'else if'";
    if (beforeLiteral) return oroforge::diag::didYouMean(word, {"return"});
    if (beforeBlock)
        return oroforge::diag::didYouMean(
            word, {"while", "for", "else", "catch", "program", "function", "export", "StateMachine"});
    return oroforge::diag::didYouMean(
        word, {"var",      "const",  "alias",  "param", "set",          "call",        "return",
               "while",    "for",    "try",    "else",  "catch",        "yield",       "program",
               "function", "export", "global", "local", "StateMachine", "RootMachine", "SubMachine"});
}

bool isLiteral(TokenKind kind) {
    return kind == TokenKind::Number || kind == TokenKind::Text || kind == TokenKind::Letter;
}

/** What to write instead of the reserved words of older versions and other languages. */
const char* insteadOf(std::string_view word) {
    if (word == "until")
        return "there are no commands any more: a call waits until it is done; for more, write 'while !arm.isReady() "
               "yield'";
    if (word == "done") return "put blocks into braces: 'while a.busy() { yield }'";
    if (word == "include") return "another script is executed by 'runScript(\"file.ops\")'";
    if (word == "define") return "a constant is declared with 'const int n = 3'";
    if (word == "foreach") return "elements are counted: 'for (var int i = 0; i < v.size; i = i + 1) …'";
    return nullptr;
}

bool beginsPlain(std::string_view word) {
    for (const std::string_view known : {"do", "set", "call", "yield", "nothing", "true", "false", "not"})
        if (word == known) return true;
    return !isReserved(word);
}

}  // namespace

/** Parses a statement without the ';' at its end. Null if failed. */
ast::StatementPtr Parser::statement() {
    if (atDeclaration()) return declaration();
    if (atWord("if")) return ifStatement();
    if (atWord("while")) return whileStatement();
    if (atWord("for")) return forStatement();
    if (atWord("try")) return tryStatement();
    if (atWord("return")) return returnStatement();
    if (atBreak()) return breakStatement();
    if (atWord("else")) failWith("OPS001", "found 'else' without an 'if' before it");
    if (atWord("catch")) failWith("OPS001", "found 'catch' without a 'try' before it");
    return plainStatement();
}

/** Skips `do`, `set` and `call`, which have no effect. */
void Parser::plainPrefix() {
    acceptWord("do");
    acceptWord("set");
    acceptWord("call");
}

void Parser::failReserved() {
    const char* const instead =
        text() == "then" ? "only the condition of 'if' is followed by 'then'" : insteadOf(text());
    auto* const error =
        failWith("OPS008", "found the reserved word '" + std::string(text()) + "', expected a statement");
    if (error && instead) error->hint(instead);
}

ast::StatementPtr Parser::plainStatement() {
    const ast::Place at = place();
    switch (token().kind) {
        case TokenKind::Word:
            if (!beginsPlain(text())) failReserved();
            break;
        case TokenKind::TypeWord:
        case TokenKind::Number:
        case TokenKind::Text:
        case TokenKind::Letter:
        case TokenKind::OpenParen:
        case TokenKind::Plus:
        case TokenKind::Minus:
        case TokenKind::Not: break;
        default: failHere("a statement"); return nullptr;
    }
    plainPrefix();
    if (acceptWord("yield")) return makeStatement(at, ast::Yield{});
    if (acceptWord("nothing")) return makeStatement(at, ast::Nothing{});
    return makeStatement(at, ast::Do{expression()});
}

ast::StatementPtr Parser::tryStatement() {
    const ast::Place at = place();
    advance();
    plainPrefix();
    ast::Try result;
    result.attempt = expression();
    if (acceptContinuation("catch")) result.handler = std::make_unique<ast::Block>(block());
    return makeStatement(at, std::move(result));
}

/** Parses `return`; the value must be on the same line. */
ast::StatementPtr Parser::returnStatement() {
    const ast::Place at = place();
    advance();
    ast::Return result;
    if (!atStatementEnd() && !atWord("else") && !atWord("catch")) result.value = expression();
    return makeStatement(at, std::move(result));
}

ast::StatementPtr Parser::ifStatement() {
    const ast::Place at = place();
    advance();
    ast::If result;
    result.condition = expression();
    expectThen();
    result.then = block();
    if (acceptContinuation("else")) result.otherwise = std::make_unique<ast::Block>(block());
    return makeStatement(at, std::move(result));
}

void Parser::expectThen() {
    const bool word = atName();
    const std::string found(word ? text() : "");
    if (!acceptWord("then")) {
        auto* error = fail("'then' after the condition");
        if (error && word) error->message += oroforge::diag::didYouMean(found, {"then"});
    }
    recoverAtBrace();
}

ast::StatementPtr Parser::whileStatement() {
    const ast::Place at = place();
    advance();
    ast::While result;
    result.condition = expression();
    recoverAtBrace();
    result.body = loopBody();
    return makeStatement(at, std::move(result));
}

/** `for (var int i = 0; i < 3; set i = i + 1) …`. */
ast::StatementPtr Parser::forStatement() {
    const ast::Place at = place();
    advance();
    ast::For result;
    forHeader(result);
    recoverAtBrace(true);
    result.body = loopBody();
    return makeStatement(at, std::move(result));
}

void Parser::forHeader(ast::For& loop) {
    const Token open = token();
    expect(TokenKind::OpenParen, "'('");
    if (at(TokenKind::Semicolon))
        loop.first = makeStatement(place(), ast::Nothing{});
    else
        loop.first = atDeclaration() ? declaration() : plainStatement();
    if (!accept(TokenKind::Semicolon)) explainNameAfter(loop.first.get(), fail("';' and the condition"));
    loop.condition = expression();
    expect(TokenKind::Semicolon, "';' and what to do after each round");
    plainPrefix();
    loop.next = expression();
    expectClosing(TokenKind::CloseParen, "')'", open);
}

/** True at the statement `break`, which can also be a name. */
bool Parser::atBreak() const {
    if (!atWord("break")) return false;
    const Token next = following();
    switch (next.kind) {
        case TokenKind::Semicolon:
        case TokenKind::CloseBrace:
        case TokenKind::End: return true;
        case TokenKind::Word: return next.newLine || text(next) == "else" || text(next) == "catch";
        default: return next.newLine;
    }
}

ast::StatementPtr Parser::breakStatement() {
    const ast::Place at = place();
    if (loops_ == 0) report(at, "OPS011", "found 'break' outside of 'for' and 'while'");
    advance();
    return makeStatement(at, ast::Break{});
}

void Parser::endAfter(const ast::StatementPtr& statement) { explainNameAfter(statement.get(), endStatement()); }

/** Adds a hint if `statement` is followed by something unexpected because its name was meant as a keyword or a type. */
void Parser::explainNameAfter(const ast::Statement* statement, oroforge::diag::Diagnostic* error) const {
    if (!error || !statement) return;
    if (std::holds_alternative<ast::Declaration>(statement->what) && token().kind == TokenKind::OpenBracket)
        error->hint("put a size into parentheses: 'var array v(3)'");
    if (const char* const instead = insteadOf(text())) {
        error->hint(instead);
        return;
    }
    const auto* only = std::get_if<ast::Do>(&statement->what);
    const auto* name = only && only->expression ? std::get_if<ast::Name>(&only->expression->what) : nullptr;
    if (only && token().kind == TokenKind::OpenParen && (!name || name->called))
        error->hint("only what has a name can be called");
    const bool blockFollows = token().kind == TokenKind::OpenBrace || text() == "then";
    if (!name || (name->called && !blockFollows)) return;
    const std::string& first = name->parts.front().text;
    const bool literal = isLiteral(token().kind) && lastEnd() != token().begin;
    const std::string meant = name->parts.size() == 1 ? meantKeyword(first, literal, blockFollows) : "";
    if (!meant.empty()) {
        error->hint("'" + first + "' is taken for a name" + meant);
    } else if (literal) {
        error->hint("put arguments into parentheses: '" + pathOf(*name) + "(…)'");
    } else if (first == "select") {
        error->hint("'select' belongs into transitions; within a program, 'requestState(\"" + std::string(text()) +
                    "\")' of the machine");
    } else if (first == "import" || first == "require") {
        error->hint("operations are called with parentheses, and texts are put into quotes: '" + first + "(\"" +
                    std::string(text()) + "\")'");
    } else if (!name->called && token().kind == TokenKind::Word && !isReserved(text())) {
        error->hint("a variable is declared with 'var " + pathOf(*name) + " " + std::string(text()) + "'");
    }
}

}  // namespace RTT::scripting::detail
