// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Functions, programs and RootMachine.
#include <rtt/scripting/detail/syntax/parse_rules.hpp>

namespace RTT::scripting::detail {

namespace {

bool isLiteral(TokenKind kind) {
    return kind == TokenKind::Number || kind == TokenKind::Text || kind == TokenKind::Letter;
}

}  // namespace

/** True at what can only be at the top level. */
bool Parser::atDefinition() const {
    for (const std::string_view word :
         {"program", "function", "export", "global", "local", "StateMachine", "RootMachine"})
        if (atWordBeforeName(word)) return true;
    return false;
}

/** True at `function f`, `double f(` or `double f {`. */
bool Parser::atFunction() const {
    for (const std::string_view word : {"function", "export", "global", "local"})
        if (atWordBeforeName(word)) return true;
    if (!(atName() || at(TokenKind::TypeWord)) || atWord("state")) return false;
    Lexer ahead = lexerHere();
    ahead.typeName(token());
    const Token name = ahead.next();
    if (name.kind != TokenKind::Word || name.newLine || !standsAsName(name)) return false;
    const Token open = ahead.next();
    // Not a function: `While true {` and the like.
    for (const std::string_view value : {"true", "false", "not"})
        if (open.kind == TokenKind::OpenBrace && text(name) == value) return false;
    if (open.kind == TokenKind::OpenParen) return !isLiteral(ahead.next().kind);
    return open.kind == TokenKind::OpenBrace;
}

ast::Function Parser::function() {
    typedef ast::Function::Scope Scope;
    ast::Function result;
    if (acceptWord("export")) {
        result.scope = Scope::Exported;
    } else if (acceptWord("global")) {
        result.scope = Scope::Global;
    } else {
        acceptWord("local");
    }
    const ast::Place at = place();
    if (acceptWord("function")) {
        result.type = {"void", at};
    } else {
        result.type = typeName();
    }
    result.name = name("the name of a function");
    if (this->at(TokenKind::OpenParen)) functionArguments(result);
    loops_ = 0;
    recoverAtBrace();
    result.body = body();
    return result;
}

/** `()`, `(void)`, `(int a, strings b(3))`. */
void Parser::functionArguments(ast::Function& function) {
    const Token open = token();
    advance();
    const Token next = following();
    if (atWord("void") && next.kind == TokenKind::CloseParen) advance();
    if (accept(TokenKind::CloseParen)) return;
    do {
        ast::Function::Argument argument;
        argument.type = typeName();
        argument.name = name("the name of an argument");
        argument.size = sizeHint();
        function.arguments.push_back(std::move(argument));
    } while (accept(TokenKind::Comma));
    expectClosing(TokenKind::CloseParen, "',' or ')'", open);
}

ast::Program Parser::program() {
    ast::Program result;
    advance();
    result.name = name("the name of a program");
    loops_ = 0;
    recoverAtBrace();
    result.body = body();
    return result;
}

/** `RootMachine T n(p = 1)`, and the same with SubMachine. */
ast::Instance Parser::instance() {
    ast::Instance result;
    result.at = place();
    advance();
    result.type = name("the type of a state machine");
    result.name = name("a name for the state machine");
    if (at(TokenKind::OpenParen)) instanceArguments(result);
    return result;
}

void Parser::instanceArguments(ast::Instance& instance) {
    const Token open = token();
    advance();
    if (accept(TokenKind::CloseParen)) return;
    do {
        ast::Instance::Argument argument;
        argument.name = name("the name of a parameter");
        expect(TokenKind::Assign, "'=' and the value of the parameter");
        argument.value = expression();
        instance.arguments.push_back(std::move(argument));
    } while (accept(TokenKind::Comma));
    expectClosing(TokenKind::CloseParen, "',' or ')'", open);
}

}  // namespace RTT::scripting::detail
