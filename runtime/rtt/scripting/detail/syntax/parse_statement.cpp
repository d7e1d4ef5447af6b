// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/syntax/parse_grammar.hpp>

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

ast::StatementPtr StatementParser::parse() {
    if (ahead_.atDeclaration()) return grammar_.declarations.declaration();
    if (tokens_.atWord("if")) return ifStatement();
    if (tokens_.atWord("while")) return whileStatement();
    if (tokens_.atWord("for")) return forStatement();
    if (tokens_.atWord("try")) return tryStatement();
    if (tokens_.atWord("return")) return returnStatement();
    if (ahead_.atBreak()) return breakStatement();
    if (tokens_.atWord("else")) tokens_.failWith("OPS001", "found 'else' without an 'if' before it");
    if (tokens_.atWord("catch")) tokens_.failWith("OPS001", "found 'catch' without a 'try' before it");
    return plainStatement();
}

/** Skips `do`, `set` and `call`, which have no effect. */
void StatementParser::plainPrefix() {
    tokens_.acceptWord("do");
    tokens_.acceptWord("set");
    tokens_.acceptWord("call");
}

void StatementParser::failReserved() {
    const char* const instead =
        tokens_.text() == "then" ? "only the condition of 'if' is followed by 'then'" : insteadOf(tokens_.text());
    auto* const error = tokens_.failWith(
        "OPS008", "found the reserved word '" + std::string(tokens_.text()) + "', expected a statement");
    if (error && instead) error->hint(instead);
}

ast::StatementPtr StatementParser::plainStatement() {
    const ast::Place at = tokens_.place();
    switch (tokens_.token().kind) {
        case TokenKind::Word:
            if (!beginsPlain(tokens_.text())) failReserved();
            break;
        case TokenKind::TypeWord:
        case TokenKind::Number:
        case TokenKind::Text:
        case TokenKind::Letter:
        case TokenKind::OpenParen:
        case TokenKind::Plus:
        case TokenKind::Minus:
        case TokenKind::Not: break;
        default: tokens_.failHere("a statement"); return nullptr;
    }
    plainPrefix();
    if (tokens_.acceptWord("yield")) return makeStatement(at, ast::Yield{});
    if (tokens_.acceptWord("nothing")) return makeStatement(at, ast::Nothing{});
    return makeStatement(at, ast::Do{grammar_.expressions.parse()});
}

ast::StatementPtr StatementParser::tryStatement() {
    const ast::Place at = tokens_.place();
    tokens_.advance();
    plainPrefix();
    ast::Try result;
    result.attempt = grammar_.expressions.parse();
    if (tokens_.acceptContinuation("catch")) result.handler = std::make_unique<ast::Block>(block());
    return makeStatement(at, std::move(result));
}

/** Parses `return`; the value must be on the same line. */
ast::StatementPtr StatementParser::returnStatement() {
    const ast::Place at = tokens_.place();
    tokens_.advance();
    ast::Return result;
    if (!tokens_.atStatementEnd() && !tokens_.atWord("else") && !tokens_.atWord("catch"))
        result.value = grammar_.expressions.parse();
    return makeStatement(at, std::move(result));
}

ast::StatementPtr StatementParser::ifStatement() {
    const ast::Place at = tokens_.place();
    tokens_.advance();
    ast::If result;
    result.condition = grammar_.expressions.parse();
    expectThen();
    result.then = block();
    if (tokens_.acceptContinuation("else")) result.otherwise = std::make_unique<ast::Block>(block());
    return makeStatement(at, std::move(result));
}

void StatementParser::expectThen() {
    const bool word = tokens_.atName();
    const std::string found(word ? tokens_.text() : "");
    if (!tokens_.acceptWord("then")) {
        auto* error = tokens_.fail("'then' after the condition");
        if (error && word) error->message += oroforge::diag::didYouMean(found, {"then"});
    }
    tokens_.recoverAtBrace();
}

ast::StatementPtr StatementParser::whileStatement() {
    const ast::Place at = tokens_.place();
    tokens_.advance();
    ast::While result;
    result.condition = grammar_.expressions.parse();
    tokens_.recoverAtBrace();
    result.body = loopBody();
    return makeStatement(at, std::move(result));
}

/** `for (var int i = 0; i < 3; set i = i + 1) …`. */
ast::StatementPtr StatementParser::forStatement() {
    const ast::Place at = tokens_.place();
    tokens_.advance();
    ast::For result;
    forHeader(result);
    tokens_.recoverAtBrace(true);
    result.body = loopBody();
    return makeStatement(at, std::move(result));
}

void StatementParser::forHeader(ast::For& loop) {
    const Token open = tokens_.token();
    tokens_.expect(TokenKind::OpenParen, "'('");
    if (tokens_.at(TokenKind::Semicolon))
        loop.first = makeStatement(tokens_.place(), ast::Nothing{});
    else
        loop.first = ahead_.atDeclaration() ? grammar_.declarations.declaration() : plainStatement();
    if (!tokens_.accept(TokenKind::Semicolon))
        explainNameAfter(loop.first.get(), tokens_.fail("';' and the condition"));
    loop.condition = grammar_.expressions.parse();
    tokens_.expect(TokenKind::Semicolon, "';' and what to do after each round");
    plainPrefix();
    loop.next = grammar_.expressions.parse();
    tokens_.expectClosing(TokenKind::CloseParen, "')'", open);
}

ast::StatementPtr StatementParser::breakStatement() {
    const ast::Place at = tokens_.place();
    if (loops_ == 0) tokens_.report(at, "OPS011", "found 'break' outside of 'for' and 'while'");
    tokens_.advance();
    return makeStatement(at, ast::Break{});
}

/** `{ … }`, or one statement. */
ast::Block StatementParser::block() {
    if (tokens_.at(TokenKind::OpenBrace)) return body();
    ast::Block result;
    result.at = result.end = tokens_.place();
    Nesting::Level level(grammar_.nesting);
    if (!level) return result;
    const std::size_t begin = tokens_.token().begin;
    if (tokens_.atWord("else") || tokens_.atWord("catch")) tokens_.failHere("a statement");
    ast::StatementPtr only = parse();
    if (!tokens_.atWord("else") && !tokens_.atWord("catch")) explainNameAfter(only.get(), tokens_.requireEnd());
    if (!tokens_.failed()) result.statements.push_back(std::move(only));
    tokens_.recover(begin, true);
    return result;
}

ast::Block StatementParser::loopBody() {
    ++loops_;
    ast::Block result = block();
    --loops_;
    return result;
}

ast::Block StatementParser::body() {
    ast::Block result;
    result.at = tokens_.place();
    result.end = grammar_.braces.contents(&Lookahead::blockEndsHere, [&] {
        ast::StatementPtr next = parse();
        endAfter(next);
        if (!tokens_.failed()) result.statements.push_back(std::move(next));
    });
    return result;
}

void StatementParser::endAfter(const ast::StatementPtr& statement) {
    explainNameAfter(statement.get(), tokens_.endStatement());
}

/** Adds a hint if `statement` is followed by something unexpected because its name was meant as a keyword or a type. */
void StatementParser::explainNameAfter(const ast::Statement* statement, oroforge::diag::Diagnostic* error) const {
    if (!error || !statement) return;
    if (std::holds_alternative<ast::Declaration>(statement->what) && tokens_.token().kind == TokenKind::OpenBracket)
        error->hint("put a size into parentheses: 'var array v(3)'");
    if (const char* const instead = insteadOf(tokens_.text())) {
        error->hint(instead);
        return;
    }
    const auto* only = std::get_if<ast::Do>(&statement->what);
    const auto* name = only && only->expression ? std::get_if<ast::Name>(&only->expression->what) : nullptr;
    if (only && tokens_.token().kind == TokenKind::OpenParen && (!name || name->called))
        error->hint("only what has a name can be called");
    const bool blockFollows = tokens_.token().kind == TokenKind::OpenBrace || tokens_.text() == "then";
    if (!name || (name->called && !blockFollows)) return;
    const std::string& first = name->parts.front().text;
    const bool literal = isLiteral(tokens_.token().kind) && tokens_.lastEnd() != tokens_.token().begin;
    const std::string meant = name->parts.size() == 1 ? meantKeyword(first, literal, blockFollows) : "";
    if (!meant.empty()) {
        error->hint("'" + first + "' is taken for a name" + meant);
    } else if (literal) {
        error->hint("put arguments into parentheses: '" + pathOf(*name) + "(…)'");
    } else if (first == "select") {
        error->hint("'select' belongs into transitions; within a program, 'requestState(\"" +
                    std::string(tokens_.text()) + "\")' of the machine");
    } else if (first == "import" || first == "require") {
        error->hint("operations are called with parentheses, and texts are put into quotes: '" + first + "(\"" +
                    std::string(tokens_.text()) + "\")'");
    } else if (!name->called && tokens_.token().kind == TokenKind::Word && !isReserved(tokens_.text())) {
        error->hint("a variable is declared with 'var " + pathOf(*name) + " " + std::string(tokens_.text()) + "'");
    }
}

}  // namespace RTT::scripting::detail
