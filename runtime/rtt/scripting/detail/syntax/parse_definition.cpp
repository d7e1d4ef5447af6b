// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/syntax/parse_grammar.hpp>

namespace RTT::scripting::detail {

ast::Function DefinitionParser::function() {
    typedef ast::Function::Scope Scope;
    ast::Function result;
    if (tokens_.acceptWord("export")) {
        result.scope = Scope::Exported;
    } else if (tokens_.acceptWord("global")) {
        result.scope = Scope::Global;
    } else {
        tokens_.acceptWord("local");
    }
    const ast::Place at = tokens_.place();
    if (tokens_.acceptWord("function")) {
        result.type = {"void", at};
    } else {
        result.type = tokens_.typeName();
    }
    result.name = tokens_.name("the name of a function");
    if (tokens_.at(TokenKind::OpenParen)) functionArguments(result);
    tokens_.recoverAtBrace();
    result.body = grammar_.statements.body();
    return result;
}

/** `()`, `(void)`, `(int a, strings b(3))`. */
void DefinitionParser::functionArguments(ast::Function& function) {
    const Token open = tokens_.token();
    tokens_.advance();
    const Token next = tokens_.following();
    if (tokens_.atWord("void") && next.kind == TokenKind::CloseParen) tokens_.advance();
    if (tokens_.accept(TokenKind::CloseParen)) return;
    do {
        ast::Function::Argument argument;
        argument.type = tokens_.typeName();
        argument.name = tokens_.name("the name of an argument");
        argument.size = grammar_.declarations.sizeHint();
        function.arguments.push_back(std::move(argument));
    } while (tokens_.accept(TokenKind::Comma));
    tokens_.expectClosing(TokenKind::CloseParen, "',' or ')'", open);
}

ast::Program DefinitionParser::program() {
    ast::Program result;
    tokens_.advance();
    result.name = tokens_.name("the name of a program");
    tokens_.recoverAtBrace();
    result.body = grammar_.statements.body();
    return result;
}

ast::Instance DefinitionParser::instance() {
    ast::Instance result;
    result.at = tokens_.place();
    tokens_.advance();
    result.type = tokens_.name("the type of a state machine");
    result.name = tokens_.name("a name for the state machine");
    if (tokens_.at(TokenKind::OpenParen)) instanceArguments(result);
    return result;
}

void DefinitionParser::instanceArguments(ast::Instance& instance) {
    const Token open = tokens_.token();
    tokens_.advance();
    if (tokens_.accept(TokenKind::CloseParen)) return;
    do {
        ast::Instance::Argument argument;
        argument.name = tokens_.name("the name of a parameter");
        tokens_.expect(TokenKind::Assign, "'=' and the value of the parameter");
        argument.value = grammar_.expressions.parse();
        instance.arguments.push_back(std::move(argument));
    } while (tokens_.accept(TokenKind::Comma));
    tokens_.expectClosing(TokenKind::CloseParen, "',' or ')'", open);
}

}  // namespace RTT::scripting::detail
