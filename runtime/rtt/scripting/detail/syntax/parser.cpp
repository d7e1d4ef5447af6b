// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/syntax/parser.hpp>

#include <rtt/scripting/detail/syntax/parse_rules.hpp>

#include <diag/nearest_match.hpp>

namespace RTT::scripting::detail {

namespace {

/** The keyword that `word` was meant to be, because `progam p {` is not a function of type progam; empty if there is
    none. `next` reads what follows. */
std::string meantDefinition(std::string_view word, Lexer next) {
    for (const std::string_view known : {"function", "export", "global", "local", "program", "StateMachine"})
        if (word == known) return "";
    next.next();
    if (next.next().kind != TokenKind::OpenBrace) return "";
    // Types may have similar names, so only a misspelling by one letter, or another case, is taken for a keyword.
    for (const char* const keyword : {"program", "function", "StateMachine"})
        if (oroforge::diag::editDistance(std::string(word), keyword) <= 1) return keyword;
    return "";
}

}  // namespace

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
    const std::string meant = atFunction() ? meantDefinition(text(), lexerHere()) : "";
    if (!meant.empty())
        report(
            result.at, "OPS001",
            "found '" + std::string(text()) + "', expected a definition or a statement; did you mean '" + meant + "'?");
    if (atWordBeforeName("program") || meant == "program") {
        result.what = program();
    } else if (atWordBeforeName("StateMachine") || meant == "StateMachine") {
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

}  // namespace RTT::scripting::detail
