// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/parser.hpp>

#include <rtt/scripting/detail/parse_rules.hpp>

namespace RTT {
namespace scripting {
namespace detail {

ast::Script parse(const std::string& text, const oroforge::diag::FileName& name, oroforge::diag::Sink& sink) {
    return Parser(text, name, sink).script();
}

ast::Script Parser::script() {
    ast::Script result;
    while (token().kind != TokenKind::End) {
        if (accept(TokenKind::Semicolon)) continue;
        const std::size_t begin = token().begin;
        beginStatement();
        item(result);
        recover(begin);
    }
    return result;
}

void Parser::item(ast::Script& script) {
    if (at(TokenKind::CloseBrace)) {
        strayBrace();
        return;
    }
    ast::Item result;
    result.at = place();
    result.begin = token().begin;
    loops_ = 0;
    too_deep_ = false;
    if (atWordBeforeName("program")) {
        result.what = program();
    } else if (atWordBeforeName("StateMachine")) {
        result.what = stateMachine();
    } else if (atWordBeforeName("RootMachine")) {
        result.what = instance();
    } else if (atFunction()) {
        result.what = function();
    } else {
        result.what = statement();
    }
    result.end = lastPlace();
    result.size = lastEnd() - result.begin;
    if (const auto* statement = std::get_if<ast::StatementPtr>(&result.what)) endAfter(*statement);
    if (!failed()) script.items.push_back(std::move(result));
}

void Parser::strayBrace() {
    if (assumed_closed_ > 0) {
        --assumed_closed_;
    } else {
        failWith("OPS009", "found '}' without a '{' before it");
        forget();
    }
    advance();
}

}  // namespace detail
}  // namespace scripting
}  // namespace RTT
