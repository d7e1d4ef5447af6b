// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/syntax/parse_grammar.hpp>

#include <rtt/scripting/detail/syntax/parse_literal.hpp>

#include <algorithm>

namespace RTT::scripting::detail {

namespace {

struct Operator {
    int precedence;  ///< 0: not a binary operator
    const char* name;
};

Operator binaryOperator(TokenKind kind, std::string_view text) {
    switch (kind) {
        case TokenKind::And: return {1, "&&"};
        case TokenKind::Or: return {2, "||"};
        case TokenKind::Unequal: return {3, "!="};
        case TokenKind::Equal: return {4, "=="};
        case TokenKind::GreaterEqual: return {5, ">="};
        case TokenKind::Greater: return {6, ">"};
        case TokenKind::LessEqual: return {7, "<="};
        case TokenKind::Less: return {8, "<"};
        case TokenKind::Plus: return {9, "+"};
        case TokenKind::Minus: return {9, "-"};
        case TokenKind::Modulo: return {10, "%"};
        case TokenKind::Times: return {11, "*"};
        case TokenKind::Divide: return {11, "/"};
        case TokenKind::Word: break;
        default: return {0, nullptr};
    }
    if (text == "and") return {1, "&&"};
    if (text == "or") return {2, "||"};
    return {0, nullptr};
}

/** What to write instead of operators of other languages, where `found` is in the place of a value after `before`. */
const char* habit(const Token& found, std::string_view before) {
    const auto endsWith = [before](std::string_view end) {
        return before.size() >= end.size() && before.substr(before.size() - end.size()) == end;
    };
    if (endsWith("++") || endsWith("--")) return "there are no '++' and '--'; write 'i = i + 1'";
    const bool opens = found.kind == TokenKind::OpenBrace || found.kind == TokenKind::OpenBracket;
    if (opens && endsWith("=")) return "a sequence is made by its type: 'array(1.0, 2.0)'";
    if (opens && endsWith("try")) return "'try' takes one statement: 'try a.move() catch { … }'";
    const bool computes = endsWith("+") || endsWith("-") || endsWith("*") || endsWith("/") || endsWith("%");
    return found.kind == TokenKind::Assign && computes ? "there are no '+=' and the like; write 'i = i + 1'" : nullptr;
}

bool isDot(TokenKind kind) { return kind == TokenKind::Dot || kind == TokenKind::Colon; }

}  // namespace

template <class What>
ExpressionParser::Tree ExpressionParser::tree(ast::Place at, ast::Place begin, unsigned height, What what) {
    if (height > kMaxNesting) grammar_.nesting.fail();
    if (tokens_.failed()) return {};
    Tree result;
    result.expression = std::make_unique<ast::Expression>();
    result.expression->at = at;
    result.expression->what = std::move(what);
    result.height = height;
    result.begin = begin;
    return result;
}

ExpressionParser::Tree ExpressionParser::assignment() {
    Nesting::Level level(grammar_.nesting);
    if (!level) return {};
    Tree to = binary(1);
    const ast::Place at = tokens_.place();
    if (!tokens_.accept(TokenKind::Assign)) return to;
    Tree value = assignment();
    const unsigned height = std::max(to.height, value.height) + 1;
    return tree(at, to.begin, height, ast::Assignment{std::move(to.expression), std::move(value.expression)});
}

/** Parses operators that bind at least that strongly. */
ExpressionParser::Tree ExpressionParser::binary(int least) {
    Tree left = unary();
    unsigned height = left.height;
    ast::Binary row;
    while (!tokens_.failed()) {
        const Operator found = binaryOperator(tokens_.token().kind, tokens_.text());
        if (found.precedence == 0 || found.precedence < least) break;
        if (row.steps.size() == kMaxOperators)
            tokens_.failWith("OPS010", "found more than " + std::to_string(kMaxOperators) + " operators in a row");
        const ast::Place at = tokens_.place();
        tokens_.advance();
        Tree right = binary(found.precedence + 1);
        height = std::max(height, right.height);
        row.steps.push_back({found.name, at, std::move(right.expression)});
    }
    if (row.steps.empty()) return left;
    row.first = std::move(left.expression);
    const ast::Place last = row.steps.back().at;
    return tree(last, left.begin, height + 1, std::move(row));
}

/** Each sign at most once, in this order. */
ExpressionParser::Tree ExpressionParser::unary() {
    // `i++` at the end of a line does not continue in the next one.
    const bool sign = tokens_.token().kind == TokenKind::Plus || tokens_.token().kind == TokenKind::Minus;
    if (sign && tokens_.repeated() && tokens_.lastEnd() == tokens_.token().begin && tokens_.following().newLine)
        return primary();
    const ast::Place plus = tokens_.place();
    const bool hasPlus = tokens_.accept(TokenKind::Plus);
    const ast::Place minus = tokens_.place();
    const bool hasMinus = tokens_.accept(TokenKind::Minus);
    const ast::Place negation = tokens_.place();
    const bool hasNot = tokens_.accept(TokenKind::Not) || tokens_.acceptWord("not");
    // Its magnitude alone does not fit into an int.
    ast::Value least;
    const bool isLeast = hasMinus && !hasNot && tokens_.at(TokenKind::Number) && readLeast(tokens_.text(), least);
    if (isLeast) tokens_.advance();
    Tree result = isLeast ? tree(minus, minus, 0, ast::Literal{std::move(least)}) : operand();
    const auto apply = [&](bool has, char op, ast::Place at) {
        if (has) result = tree(at, at, result.height + 1, ast::Unary{op, std::move(result.expression)});
    };
    apply(hasNot, '!', negation);
    apply(hasMinus && !isLeast, '-', minus);
    apply(hasPlus, '+', plus);
    return result;
}

ExpressionParser::Tree ExpressionParser::operand() {
    Tree of = primary();
    while (!tokens_.failed()) {
        const Token open = tokens_.token();
        if (isDot(open.kind)) {
            tokens_.advance();
            if (!tokens_.at(TokenKind::Word)) {
                tokens_.fail("the name of a member");
                return {};
            }
            const ast::Identifier member{std::string(tokens_.text()), tokens_.place()};
            tokens_.advance();
            of = tree(of.begin, of.begin, of.height + 1, ast::Member{std::move(of.expression), member});
        } else if (tokens_.accept(TokenKind::OpenBracket)) {
            Tree index = assignment();
            tokens_.expectClosing(TokenKind::CloseBracket, "']'", open);
            const unsigned height = std::max(of.height, index.height) + 1;
            of = tree(of.begin, of.begin, height, ast::Index{std::move(of.expression), std::move(index.expression)});
        } else {
            break;
        }
    }
    return of;
}

ExpressionParser::Tree ExpressionParser::primary() {
    switch (tokens_.token().kind) {
        case TokenKind::OpenParen: return parenthesis();
        case TokenKind::Number:
        case TokenKind::Text:
        case TokenKind::Letter: return literal();
        case TokenKind::Word:
        case TokenKind::TypeWord: return named();
        default: break;
    }
    oroforge::diag::Diagnostic* error = tokens_.fail("a value");
    const bool sign = tokens_.token().kind == TokenKind::Plus || tokens_.token().kind == TokenKind::Minus;
    Token before = tokens_.token();
    before.end = tokens_.lastEnd();
    before.begin = before.end - std::min<std::size_t>(before.end, 3);
    const char* const meant = habit(tokens_.token(), sign && tokens_.repeated() ? "++" : tokens_.text(before));
    if (error && meant) error->hint(meant);
    return {};
}

ExpressionParser::Tree ExpressionParser::parenthesis() {
    const Token open = tokens_.token();
    tokens_.accept(TokenKind::OpenParen);
    Tree inner = assignment();
    tokens_.expectClosing(TokenKind::CloseParen, "')'", open);
    inner.begin = {open.line, open.column};
    return inner;
}

ExpressionParser::Tree ExpressionParser::literal() {
    const ast::Place at = tokens_.place();
    ast::Value value;
    std::optional<LiteralProblem> problem;
    if (tokens_.token().kind == TokenKind::Number) {
        problem = readNumber(tokens_.text(), value);
    } else if (tokens_.token().kind == TokenKind::Text) {
        problem = readText(tokens_.text(), value.emplace<std::string>());
    } else {
        problem = readLetter(tokens_.text(), value.emplace<char>());
    }
    if (tokens_.failed()) return {};
    // Parsing continues as if it were right.
    if (problem)
        tokens_.report({at.line, at.column + static_cast<unsigned>(problem->offset)}, problem->code,
                       std::move(problem->message));
    tokens_.advance();
    return tree(at, at, 0, ast::Literal{std::move(value)});
}

/** A truth value, the time, or a path of names, maybe called. */
ExpressionParser::Tree ExpressionParser::named() {
    const ast::Place begin = tokens_.place();
    if (tokens_.acceptWord("true")) return tree(begin, begin, 0, ast::Literal{true});
    if (tokens_.acceptWord("false")) return tree(begin, begin, 0, ast::Literal{false});
    const bool time = tokens_.atWord("time");
    ast::Name name;
    unsigned height = 0;
    if (tokens_.at(TokenKind::TypeWord)) {
        name.parts.push_back({std::string(tokens_.text()), begin});
        tokens_.advance();
    } else {
        name.parts.push_back(tokens_.name("a value"));
    }
    while (isDot(tokens_.token().kind) && !tokens_.failed()) {
        tokens_.advance();
        if (!tokens_.at(TokenKind::Word) && !tokens_.at(TokenKind::TypeWord)) {
            tokens_.fail("a name");
            return {};
        }
        name.parts.push_back({std::string(tokens_.text()), tokens_.place()});
        tokens_.advance();
    }
    if (tokens_.at(TokenKind::OpenParen)) name.called = arguments(name.arguments, height);
    if (time && name.parts.size() == 1 && !name.called) return tree(begin, begin, 0, ast::CurrentTime{});
    return tree(begin, begin, height, std::move(name));
}

bool ExpressionParser::arguments(ast::Expressions& to, unsigned& height) {
    const Token open = tokens_.token();
    tokens_.accept(TokenKind::OpenParen);
    if (tokens_.accept(TokenKind::CloseParen)) return true;
    do {
        Tree argument = assignment();
        height = std::max(height, argument.height + 1);
        to.push_back(std::move(argument.expression));
    } while (tokens_.accept(TokenKind::Comma));
    return tokens_.expectClosing(TokenKind::CloseParen, "',' or ')'", open);
}

}  // namespace RTT::scripting::detail
