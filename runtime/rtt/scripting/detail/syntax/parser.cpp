// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/syntax/parser.hpp>

#include <rtt/scripting/detail/syntax/parse_grammar.hpp>

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

class ScriptParser : private Rules {
public:
    explicit ScriptParser(Grammar& grammar) : Rules(grammar) {}

    ast::Script script();

private:
    void item(ast::Script& script);
};

ast::Script ScriptParser::script() {
    ast::Script result;
    while (tokens_.token().kind != TokenKind::End) {
        if (tokens_.accept(TokenKind::Semicolon)) continue;
        const std::size_t begin = tokens_.token().begin;
        tokens_.beginStatement();
        item(result);
        tokens_.recover(begin);
    }
    return result;
}

void ScriptParser::item(ast::Script& script) {
    if (tokens_.at(TokenKind::CloseBrace)) {
        grammar_.braces.skipStray();
        return;
    }
    ast::Item result;
    result.at = tokens_.place();
    result.begin = tokens_.token().begin;
    grammar_.nesting.beginItem();
    const std::string meant = ahead_.atFunction() ? meantDefinition(tokens_.text(), tokens_.lexerHere()) : "";
    if (!meant.empty())
        tokens_.report(result.at, "OPS001",
                       "found '" + std::string(tokens_.text()) +
                           "', expected a definition or a statement; did you mean '" + meant + "'?");
    if (tokens_.atWordBeforeName("program") || meant == "program") {
        result.what = grammar_.definitions.program();
    } else if (tokens_.atWordBeforeName("StateMachine") || meant == "StateMachine") {
        result.what = grammar_.machines.parse();
    } else if (tokens_.atWordBeforeName("RootMachine")) {
        result.what = grammar_.definitions.instance();
    } else if (ahead_.atFunction()) {
        result.what = grammar_.definitions.function();
    } else {
        result.what = grammar_.statements.parse();
    }
    result.end = tokens_.lastPlace();
    result.size = tokens_.lastEnd() - result.begin;
    if (const auto* statement = std::get_if<ast::StatementPtr>(&result.what)) grammar_.statements.endAfter(*statement);
    if (!tokens_.failed()) script.items.push_back(std::move(result));
}

}  // namespace

ast::Script parse(const std::string& text, const oroforge::diag::FileName& name, oroforge::diag::Sink& sink) {
    Grammar grammar(text, name, sink);
    return ScriptParser(grammar).script();
}

}  // namespace RTT::scripting::detail
