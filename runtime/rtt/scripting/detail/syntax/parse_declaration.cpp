// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/syntax/parse_rules.hpp>

namespace RTT::scripting::detail {

bool Parser::atDeclaration() const { return atWord("var") || atWord("const") || atWord("alias"); }

/** `var T a, b(2), c = 3`, `const T a = 1`, `alias T a = b`. */
ast::StatementPtr Parser::declaration() {
    typedef ast::Declaration::Kind Kind;
    const ast::Place at = place();
    const Kind kind = atWord("var") ? Kind::Variable : atWord("const") ? Kind::Constant : Kind::Alias;
    advance();
    ast::Declaration result;
    result.kind = kind;
    result.type = typeName();
    do {
        result.names.push_back(declarator(kind));
    } while (kind != Kind::Alias && accept(TokenKind::Comma));
    return makeStatement(at, std::move(result));
}

ast::Declarator Parser::declarator(ast::Declaration::Kind kind) {
    typedef ast::Declaration::Kind Kind;
    ast::Declarator result;
    result.name = name(kind == Kind::Variable   ? "the name of a variable"
                       : kind == Kind::Constant ? "the name of a constant"
                       : kind == Kind::Alias    ? "the name of an alias"
                                                : "the name of a parameter");
    if (kind == Kind::Variable || kind == Kind::Parameter) result.size = sizeHint();
    if (kind == Kind::Parameter) return result;
    if (kind != Kind::Variable && !at(TokenKind::Assign)) fail("'=' and a value");
    if (accept(TokenKind::Assign)) result.value = expression();
    return result;
}

/** The `(3)` of `var strings s(3)`, or null. */
ast::ExpressionPtr Parser::sizeHint() {
    const Token open = token();
    if (!accept(TokenKind::OpenParen)) return nullptr;
    ast::ExpressionPtr size = expression();
    if (at(TokenKind::Comma)) {
        fail("')': a variable takes one number, its size; values are given with '= T(…)'");
    } else {
        expectClosing(TokenKind::CloseParen, "')'", open);
    }
    return size;
}

/** `param T a, b`. */
ast::StatementPtr Parser::parameters() {
    const ast::Place at = place();
    advance();
    ast::Declaration result;
    result.kind = ast::Declaration::Kind::Parameter;
    result.type = typeName();
    do {
        result.names.push_back(declarator(result.kind));
    } while (accept(TokenKind::Comma));
    if (this->at(TokenKind::Assign))
        fail("the end of the line: parameters get their values from 'RootMachine' or 'SubMachine'");
    return makeStatement(at, std::move(result));
}

}  // namespace RTT::scripting::detail
