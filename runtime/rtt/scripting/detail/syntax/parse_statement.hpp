// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Statements and blocks.
#ifndef ORO_SCRIPTING_DETAIL_PARSE_STATEMENT_HPP
#define ORO_SCRIPTING_DETAIL_PARSE_STATEMENT_HPP

#include <rtt/scripting/detail/syntax/parse_rules.hpp>

namespace RTT::scripting::detail {

template <class What>
ast::StatementPtr makeStatement(ast::Place at, What what) {
    auto result = std::make_unique<ast::Statement>();
    result->at = at;
    result->what = std::move(what);
    return result;
}

class StatementParser : private Rules {
public:
    explicit StatementParser(Grammar& grammar) : Rules(grammar) {}

    /** Parses a statement without the ';' at its end. Null if failed. */
    ast::StatementPtr parse();
    void endAfter(const ast::StatementPtr& statement);
    /** `{ … }` and nothing else. */
    ast::Block body();

private:
    ast::Block block();
    ast::Block loopBody();
    ast::StatementPtr plainStatement();
    void failReserved();
    void plainPrefix();
    ast::StatementPtr tryStatement();
    ast::StatementPtr returnStatement();
    ast::StatementPtr ifStatement();
    ast::StatementPtr whileStatement();
    ast::StatementPtr forStatement();
    void forHeader(ast::For& loop);
    ast::StatementPtr breakStatement();
    void expectThen();
    void explainNameAfter(const ast::Statement* statement, oroforge::diag::Diagnostic* error) const;

    unsigned loops_ = 0;  // number of loops around the present statement
};

}  // namespace RTT::scripting::detail

#endif
