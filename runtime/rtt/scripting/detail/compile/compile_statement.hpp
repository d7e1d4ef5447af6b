// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Compiles statements and blocks.
#ifndef ORO_SCRIPTING_DETAIL_COMPILE_STATEMENT_HPP
#define ORO_SCRIPTING_DETAIL_COMPILE_STATEMENT_HPP

#include <rtt/scripting/detail/compile/unit_part.hpp>

namespace RTT::scripting::detail {

class StatementCompiler : private UnitPart {
public:
    explicit StatementCompiler(UnitCompiler& unit) : UnitPart(unit) {}

    void compile(const ast::Statement& statement);
    /** Goes on with the next statement after an error. */
    void compile(const std::vector<ast::StatementPtr>& statements);
    /** Compiles arguments, result and statements. Throws nothing. */
    void function(const ast::Function& function, bool withBody);
    /** Adds the last instruction. */
    void end();

private:
    void evaluate(const ast::Expression& expression);
    void attempt(const ast::Try& attempt);
    void giveBack(const ast::Return& statement);
    void choose(const ast::If& statement);
    void repeat(const ast::For& loop);
    void loop(const ast::Expression& condition, const ast::Block& body, const ast::Expression* next);
    std::size_t jumpUnless(const ast::Expression& condition);
    std::size_t jump();
    void land(std::size_t jump);
    void jumpBack(std::size_t target);

    std::vector<std::vector<std::size_t>> breaks_;  // jumps out of each loop around, without targets yet
};

}  // namespace RTT::scripting::detail

#endif
