// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The grammar, with a function for each rule. Precedences are those of the original: && binds weaker than ||, % than *.
#ifndef ORO_SCRIPTING_DETAIL_PARSE_RULES_HPP
#define ORO_SCRIPTING_DETAIL_PARSE_RULES_HPP

#include <rtt/scripting/detail/syntax/parse_tokens.hpp>

#include <memory>
#include <utility>

namespace RTT::scripting::detail {

class Parser : private TokenReader {
public:
    Parser(std::string_view text, const oroforge::diag::FileName& name, oroforge::diag::Sink& sink)
        : TokenReader(text, name, sink) {}

    ast::Script script();

private:
    /** An expression with its depth and its first letter, because `at` of an operation is its operator. */
    struct Tree {
        ast::ExpressionPtr expression;
        unsigned height = 0;
        ast::Place begin;
    };

    // parse_expression.cpp
    ast::ExpressionPtr expression();
    Tree assignment();
    Tree binary(int least);
    Tree unary();
    Tree operand();
    Tree primary();
    Tree parenthesis();
    Tree literal();
    Tree named();
    bool arguments(ast::Expressions& to, unsigned& height);
    template <class What>
    Tree tree(ast::Place at, ast::Place begin, unsigned height, What what);

    // parse_statement.cpp
    ast::StatementPtr statement();
    ast::StatementPtr plainStatement();
    void failReserved();
    void plainPrefix();
    ast::StatementPtr tryStatement();
    ast::StatementPtr returnStatement();
    ast::StatementPtr ifStatement();
    ast::StatementPtr whileStatement();
    ast::StatementPtr forStatement();
    void forHeader(ast::For& loop);
    bool atBreak() const;
    ast::StatementPtr breakStatement();
    void expectThen();
    void explainNameAfter(const ast::Statement* statement, oroforge::diag::Diagnostic* error) const;
    void endAfter(const ast::StatementPtr& statement);

    // parse_block.cpp
    ast::Block block();
    ast::Block loopBody();
    ast::Block body();
    bool acceptContinuation(std::string_view word);
    bool blockEndsHere() const;
    bool openBraces(Token& open);
    void closeBraces(const Token& open);
    template <class Item>
    ast::Place inBraces(bool (Parser::*endsHere)() const, Item item);

    // parse_declaration.cpp
    bool atDeclaration() const;
    ast::StatementPtr declaration();
    ast::StatementPtr parameters();
    ast::Declarator declarator(ast::Declaration::Kind kind);
    ast::ExpressionPtr sizeHint();

    // parse_definition.cpp
    bool atDefinition() const;
    bool atFunction() const;
    ast::Function function();
    void functionArguments(ast::Function& function);
    ast::Program program();
    ast::Instance instance();
    void instanceArguments(ast::Instance& instance);

    // parse_machine.cpp
    ast::StateMachine stateMachine();
    void machineItem(ast::StateMachine& machine);
    bool atState() const;
    bool machineEndsHere() const;
    bool stateEndsHere() const;
    bool atStateItem() const;
    ast::State state();
    void stateItem(ast::State& state);
    void stateProgram(ast::State& state);
    void preconditions(ast::State& state);
    void precondition(ast::State& state);

    // parse_transition.cpp
    bool atTransitions() const;
    void transitions(std::vector<ast::Transition>& to);
    ast::Transition transition();
    void event(ast::Transition& transition);
    bool atSelect() const;
    bool atSelection() const;
    ast::Selection selection();

    // parser.cpp
    void item(ast::Script& script);
    void strayBrace();

    /** One level of nesting, while it exists. */
    class Level {
    public:
        explicit Level(Parser& parser) : parser_(parser), ok_(parser.enter()) {}
        Level(const Level&) = delete;
        Level& operator=(const Level&) = delete;
        ~Level() { --parser_.level_; }
        explicit operator bool() const { return ok_; }

    private:
        Parser& parser_;
        bool ok_;
    };
    bool enter();
    void failTooDeep();

    unsigned level_ = 0;
    bool too_deep_ = false;              // reported for the present item
    unsigned loops_ = 0;                 // number of loops around the present statement
    bool in_machine_ = false;            // in a state machine
    unsigned assumed_closed_ = 0;        // blocks whose '}' is missing, though it may come later
    std::size_t assumed_at_ = kNowhere;  // the token before which they end
    static constexpr std::size_t kNowhere = ~std::size_t{0};
};

/** Parses the contents of braces, with `item` for each piece, up to '}' or to `endsHere`, where the '}' is missing.
    Returns the place of the '}'. */
template <class Item>
ast::Place Parser::inBraces(bool (Parser::*endsHere)() const, Item item) {
    Token open;
    Level level(*this);
    if (!level || !openBraces(open)) return place();
    while (!failed() && !at(TokenKind::CloseBrace) && !at(TokenKind::End) && !(this->*endsHere)()) {
        if (accept(TokenKind::Semicolon)) continue;
        const std::size_t begin = token().begin;
        beginStatement();
        item();
        recover(begin);
    }
    const ast::Place end = place();
    closeBraces(open);
    return end;
}

template <class What>
ast::StatementPtr makeStatement(ast::Place at, What what) {
    auto result = std::make_unique<ast::Statement>();
    result->at = at;
    result->what = std::move(what);
    return result;
}

}  // namespace RTT::scripting::detail

#endif
