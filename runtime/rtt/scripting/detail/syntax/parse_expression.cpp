// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// assignment → binary (eleven precedences) → unary → operand (with members and indices) → primary.
#include <rtt/scripting/detail/syntax/parse_rules.hpp>

#include <rtt/scripting/detail/syntax/parse_literal.hpp>
#include <rtt/scripting/detail/syntax/parser.hpp>

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
Parser::Tree Parser::tree(ast::Place at, ast::Place begin, unsigned height, What what) {
    if (height > kMaxNesting) failTooDeep();
    if (failed()) return {};
    Tree result;
    result.expression = std::make_unique<ast::Expression>();
    result.expression->at = at;
    result.expression->what = std::move(what);
    result.height = height;
    result.begin = begin;
    return result;
}

/** Parses an expression; null if failed. */
ast::ExpressionPtr Parser::expression() { return assignment().expression; }

Parser::Tree Parser::assignment() {
    Level level(*this);
    if (!level) return {};
    Tree to = binary(1);
    const ast::Place at = place();
    if (!accept(TokenKind::Assign)) return to;
    Tree value = assignment();
    const unsigned height = std::max(to.height, value.height) + 1;
    return tree(at, to.begin, height, ast::Assignment{std::move(to.expression), std::move(value.expression)});
}

/** Parses operators that bind at least that strongly. */
Parser::Tree Parser::binary(int least) {
    Tree left = unary();
    unsigned height = left.height;
    ast::Binary row;
    while (!failed()) {
        const Operator found = binaryOperator(token().kind, text());
        if (found.precedence == 0 || found.precedence < least) break;
        if (row.steps.size() == kMaxOperators)
            failWith("OPS010", "found more than " + std::to_string(kMaxOperators) + " operators in a row");
        const ast::Place at = place();
        advance();
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
Parser::Tree Parser::unary() {
    // `i++` at the end of a line does not continue in the next one.
    const bool sign = token().kind == TokenKind::Plus || token().kind == TokenKind::Minus;
    if (sign && repeated() && lastEnd() == token().begin && following().newLine) return primary();
    const ast::Place plus = place();
    const bool hasPlus = accept(TokenKind::Plus);
    const ast::Place minus = place();
    const bool hasMinus = accept(TokenKind::Minus);
    const ast::Place negation = place();
    const bool hasNot = accept(TokenKind::Not) || acceptWord("not");
    // Its magnitude alone does not fit into an int.
    ast::Value least;
    const bool isLeast = hasMinus && !hasNot && at(TokenKind::Number) && readLeast(text(), least);
    if (isLeast) advance();
    Tree result = isLeast ? tree(minus, minus, 0, ast::Literal{std::move(least)}) : operand();
    const auto apply = [&](bool has, char op, ast::Place at) {
        if (has) result = tree(at, at, result.height + 1, ast::Unary{op, std::move(result.expression)});
    };
    apply(hasNot, '!', negation);
    apply(hasMinus && !isLeast, '-', minus);
    apply(hasPlus, '+', plus);
    return result;
}

Parser::Tree Parser::operand() {
    Tree of = primary();
    while (!failed()) {
        const Token open = token();
        if (isDot(open.kind)) {
            advance();
            if (!at(TokenKind::Word)) {
                fail("the name of a member");
                return {};
            }
            const ast::Identifier member{std::string(text()), place()};
            advance();
            of = tree(of.begin, of.begin, of.height + 1, ast::Member{std::move(of.expression), member});
        } else if (accept(TokenKind::OpenBracket)) {
            Tree index = assignment();
            expectClosing(TokenKind::CloseBracket, "']'", open);
            const unsigned height = std::max(of.height, index.height) + 1;
            of = tree(of.begin, of.begin, height, ast::Index{std::move(of.expression), std::move(index.expression)});
        } else {
            break;
        }
    }
    return of;
}

Parser::Tree Parser::primary() {
    switch (token().kind) {
        case TokenKind::OpenParen: return parenthesis();
        case TokenKind::Number:
        case TokenKind::Text:
        case TokenKind::Letter: return literal();
        case TokenKind::Word:
        case TokenKind::TypeWord: return named();
        default: break;
    }
    oroforge::diag::Diagnostic* error = fail("a value");
    const bool sign = token().kind == TokenKind::Plus || token().kind == TokenKind::Minus;
    Token before = token();
    before.end = lastEnd();
    before.begin = before.end - std::min<std::size_t>(before.end, 3);
    const char* const meant = habit(token(), sign && repeated() ? "++" : text(before));
    if (error && meant) error->hint(meant);
    return {};
}

Parser::Tree Parser::parenthesis() {
    const Token open = token();
    accept(TokenKind::OpenParen);
    Tree inner = assignment();
    expectClosing(TokenKind::CloseParen, "')'", open);
    inner.begin = {open.line, open.column};
    return inner;
}

Parser::Tree Parser::literal() {
    const ast::Place at = place();
    ast::Value value;
    std::optional<LiteralProblem> problem;
    if (token().kind == TokenKind::Number) {
        problem = readNumber(text(), value);
    } else if (token().kind == TokenKind::Text) {
        problem = readText(text(), value.emplace<std::string>());
    } else {
        problem = readLetter(text(), value.emplace<char>());
    }
    if (failed()) return {};
    // Parsing continues as if it were right.
    if (problem)
        report({at.line, at.column + static_cast<unsigned>(problem->offset)}, problem->code,
               std::move(problem->message));
    advance();
    return tree(at, at, 0, ast::Literal{std::move(value)});
}

/** A truth value, the time, or a path of names, maybe called. */
Parser::Tree Parser::named() {
    const ast::Place begin = place();
    if (acceptWord("true")) return tree(begin, begin, 0, ast::Literal{true});
    if (acceptWord("false")) return tree(begin, begin, 0, ast::Literal{false});
    const bool time = atWord("time");
    ast::Name name;
    unsigned height = 0;
    if (at(TokenKind::TypeWord)) {
        name.parts.push_back({std::string(text()), begin});
        advance();
    } else {
        name.parts.push_back(this->name("a value"));
    }
    while (isDot(token().kind) && !failed()) {
        advance();
        if (!at(TokenKind::Word) && !at(TokenKind::TypeWord)) {
            fail("a name");
            return {};
        }
        name.parts.push_back({std::string(text()), place()});
        advance();
    }
    if (at(TokenKind::OpenParen)) name.called = arguments(name.arguments, height);
    if (time && name.parts.size() == 1 && !name.called) return tree(begin, begin, 0, ast::CurrentTime{});
    return tree(begin, begin, height, std::move(name));
}

/** Parses arguments with their parentheses. False if failed. */
bool Parser::arguments(ast::Expressions& to, unsigned& height) {
    const Token open = token();
    accept(TokenKind::OpenParen);
    if (accept(TokenKind::CloseParen)) return true;
    do {
        Tree argument = assignment();
        height = std::max(height, argument.height + 1);
        to.push_back(std::move(argument.expression));
    } while (accept(TokenKind::Comma));
    return expectClosing(TokenKind::CloseParen, "',' or ')'", open);
}

bool Parser::enter() {
    if (++level_ <= kMaxNesting) return !failed();
    failTooDeep();
    return false;
}

/** Reports once per item, because enclosing expressions are too deep for the same reason. */
void Parser::failTooDeep() {
    if (std::exchange(too_deep_, true)) {
        giveUp();
        return;
    }
    failWith("OPS010", "found expressions or blocks in each other more than " + std::to_string(kMaxNesting) + " deep");
}

}  // namespace RTT::scripting::detail
