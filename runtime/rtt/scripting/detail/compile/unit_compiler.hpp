// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Compiles one piece of script.
#ifndef ORO_SCRIPTING_DETAIL_UNIT_COMPILER_HPP
#define ORO_SCRIPTING_DETAIL_UNIT_COMPILER_HPP

#include <rtt/scripting/detail/compile/compile_declaration.hpp>
#include <rtt/scripting/detail/compile/compile_expression.hpp>
#include <rtt/scripting/detail/compile/compile_send.hpp>
#include <rtt/scripting/detail/compile/compile_statement.hpp>
#include <rtt/scripting/detail/compile/compile_value.hpp>
#include <rtt/scripting/detail/compile/unknown_name.hpp>

#include <set>

namespace RTT::scripting::detail {

struct Compiler::State {
    explicit State(CompileContext context) : where(std::move(context)) {}

    CompileContext where;
    /** All compiled code owns all activations. They do not own each other, because a chain of thousands would be
        destroyed by recursion. */
    struct Activations {
        /** The activation of each function; null while it is being compiled. */
        std::map<const FunctionDefinition*, std::unique_ptr<Activation>> of;
    };
    const std::shared_ptr<Activations> activations = std::make_shared<Activations>();
    std::vector<std::shared_ptr<const FunctionDefinition>> calls;  ///< direct calls of a function that is checked
    std::set<const FunctionDefinition*> failed;                    ///< functions with errors, which were reported
    unsigned quiet = 0;                                            ///< if not 0, no warnings are given
    bool callsOnly = false;                                        ///< called functions are not compiled

    /** The activation in this root, made at the first request; null if the function calls itself. Throws Unresolved if
        it has errors. */
    Activation* activate(const std::shared_ptr<const FunctionDefinition>& definition);
    /** Compiles the functions that it calls, and those that they call, without recursion. */
    void activateCalls(const FunctionDefinition& definition);
    /** Reports errors and then returns null. */
    std::unique_ptr<Activation> compile(const FunctionDefinition& definition);
};

/** The parts of the compiler, one for each subject, and what they share. Statements contain expressions, expressions
    names, names calls, and calls expressions, so the parts refer to each other. */
struct UnitCompiler {
    /** `function` is null unless this is the body of a function. */
    UnitCompiler(Compiler::State& state, const CompileContext& where, Code& code, Scope& scope,
                 Activation* function = nullptr)
        : state(state), where(where), code(code), scope(scope), function(function), reporter(where, state.quiet) {}

    Compiler::State& state;
    const CompileContext& where;
    Code& code;
    Scope& scope;  ///< gets what is declared
    Activation* const function;
    unsigned executions = 0;  ///< number of calls, and of assignments inside expressions
    Reporter reporter;

    // They report errors and then throw Unresolved, unless they say otherwise.
    ValueCompiler values{*this};
    ExpressionCompiler expressions{*this};
    NameCompiler names{*this};
    UnknownName unknownName{*this};
    CallCompiler calls{*this};
    SendCompiler sends{*this};
    DeclarationCompiler declarations{*this};
    StatementCompiler statements{*this};
};

inline UnitPart::UnitPart(UnitCompiler& unit)
    : unit_(unit), where_(unit.where), code_(unit.code), reporter_(unit.reporter), values_(unit.values) {}

}  // namespace RTT::scripting::detail

#endif
