// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/syntax/parse_grammar.hpp>

namespace RTT::scripting::detail {

ast::StatementPtr DeclarationParser::declaration() {
    typedef ast::Declaration::Kind Kind;
    const ast::Place at = tokens_.place();
    const Kind kind = tokens_.atWord("var") ? Kind::Variable : tokens_.atWord("const") ? Kind::Constant : Kind::Alias;
    tokens_.advance();
    ast::Declaration result;
    result.kind = kind;
    result.type = tokens_.typeName();
    do {
        result.names.push_back(declarator(kind));
    } while (kind != Kind::Alias && tokens_.accept(TokenKind::Comma));
    return makeStatement(at, std::move(result));
}

ast::Declarator DeclarationParser::declarator(ast::Declaration::Kind kind) {
    typedef ast::Declaration::Kind Kind;
    ast::Declarator result;
    result.name = tokens_.name(kind == Kind::Variable   ? "the name of a variable"
                               : kind == Kind::Constant ? "the name of a constant"
                               : kind == Kind::Alias    ? "the name of an alias"
                                                        : "the name of a parameter");
    if (kind == Kind::Variable || kind == Kind::Parameter) result.size = sizeHint();
    if (kind == Kind::Parameter) return result;
    if (kind != Kind::Variable && !tokens_.at(TokenKind::Assign)) tokens_.fail("'=' and a value");
    if (tokens_.accept(TokenKind::Assign)) result.value = grammar_.expressions.parse();
    return result;
}

ast::ExpressionPtr DeclarationParser::sizeHint() {
    const Token open = tokens_.token();
    if (!tokens_.accept(TokenKind::OpenParen)) return nullptr;
    ast::ExpressionPtr size = grammar_.expressions.parse();
    if (tokens_.at(TokenKind::Comma)) {
        tokens_.fail("')': a variable takes one number, its size; values are given with '= T(…)'");
    } else {
        tokens_.expectClosing(TokenKind::CloseParen, "')'", open);
    }
    return size;
}

ast::StatementPtr DeclarationParser::parameters() {
    const ast::Place at = tokens_.place();
    tokens_.advance();
    ast::Declaration result;
    result.kind = ast::Declaration::Kind::Parameter;
    result.type = tokens_.typeName();
    do {
        result.names.push_back(declarator(result.kind));
    } while (tokens_.accept(TokenKind::Comma));
    if (tokens_.at(TokenKind::Assign))
        tokens_.fail("the end of the line: parameters get their values from 'RootMachine' or 'SubMachine'");
    return makeStatement(at, std::move(result));
}

}  // namespace RTT::scripting::detail
