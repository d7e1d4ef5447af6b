// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Compiles one piece of script. Its functions are in compile_*.cpp, by subject.
#ifndef ORO_SCRIPTING_DETAIL_UNIT_HPP
#define ORO_SCRIPTING_DETAIL_UNIT_HPP

#include <rtt/Service.hpp>
#include <rtt/scripting/detail/compile/compiler.hpp>
#include <rtt/scripting/detail/compile/operand.hpp>
#include <rtt/types/conversion_watch.hpp>
#include <rtt/types/refusal_watch.hpp>

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace RTT::scripting::detail {

/** Thrown within the compiler after an error was reported. */
struct Unresolved {};

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

class UnitCompiler {
public:
    /** `function` is null unless this is the body of a function. */
    UnitCompiler(Compiler::State& state, const CompileContext& where, Code& code, Scope& scope,
                 Activation* function = nullptr)
        : state_(state), where_(where), code_(code), scope_(&scope), function_(function) {}

    // All of these report errors; those that return a value then throw Unresolved.
    // -- Statements (compile_statement.cpp, compile_declaration.cpp) -----------------------------------------
    /** Goes on with the next statement after an error. */
    void block(const ast::Block& block);
    void statement(const ast::Statement& statement);
    void begin(ast::Place at) { code_.beginStatement(at); }
    /** Adds the last instruction. */
    void end();
    /** Compiles arguments, result and statements. */
    void function(const ast::Function& function, bool withBody);
    void declare(const ast::Declaration& declaration, bool again = false);
    /** A new variable of that type. */
    base::DataSourceBase::shared_ptr newVariable(const ast::Identifier& type, const ast::Identifier& name,
                                                 const ast::Expression* size);

    // -- Expressions -----------------------------------------------------------------------------------------
    Operand expression(const ast::Expression& expression);
    /** Loads the value to an address. Direct kinds only. */
    Operand load(Operand operand);
    /** Loads and converts the value. */
    Operand loadAs(Operand operand, Kind kind);
    /** Widens a small number to a kind with which instructions compute; leaves others as they are. */
    Operand promoted(Operand operand);
    /** Compiles a condition. */
    Operand truth(const ast::Expression& expression);
    /** A source of the value. */
    base::DataSourceBase::shared_ptr sourceOf(const Operand& operand);
    /** Evaluates it for its effects. */
    void discard(const Operand& operand);
    /** Assigns a value, converted if needed. `what` is for messages: "variable 'x'". */
    void store(const Operand& to, Operand value, const std::string& what);

    const types::TypeInfo& type(const ast::Identifier& name);
    Operand fromSource(base::DataSourceBase::shared_ptr source, ast::Place at);

private:
    typedef std::vector<ast::Identifier> Parts;
    typedef base::DataSourceBase::shared_ptr Source;
    /** A component or service on the way along a path. */
    struct Node {
        TaskContext* component;  ///< null if it is a service
        Service::shared_ptr service;
        std::size_t used;  ///< parts of the path that lead here
    };
    struct Callable {
        OperationInterfacePart* part = nullptr;
        Service* of = nullptr;  ///< the owner of the operation; null if it is global
        std::shared_ptr<const FunctionDefinition> function;
    };

    // compile_statement.cpp
    void evaluate(const ast::Expression& expression);
    void attempt(const ast::Try& attempt);
    void giveBack(const ast::Return& statement);
    void choose(const ast::If& statement);
    void repeat(const ast::While& loop);
    void repeat(const ast::For& loop);
    void loop(const ast::Expression* condition, const ast::Block& body, const ast::Expression* next);
    std::size_t jumpUnless(const Operand& condition);
    std::size_t jump();
    void land(std::size_t jump);
    void jumpBack(std::size_t target);

    // compile_declaration.cpp
    void declareConstant(const ast::Declaration& declaration, const ast::Declarator& declarator);
    void declareAlias(const ast::Declaration& declaration, const ast::Declarator& declarator);
    void declareVariable(const ast::Declaration& declaration, const ast::Declarator& declarator, bool again);
    void declareHandle(const ast::Declarator& declarator);
    void functionHead(const ast::Function& function);
    void declareArgument(const ast::Function::Argument& argument);
    void addEntry(const ast::Identifier& name, Scope::Entry entry);
    int sizeHint(const ast::Expression& size, const std::string& type, const ast::Identifier& name);

    // compile_expression.cpp
    Operand literal(const ast::Literal& literal, ast::Place at);
    Operand currentTime(ast::Place at);
    Operand member(const Operand& of, const ast::Identifier& name);
    Operand element(const ast::Index& index, ast::Place at);
    Operand unary(const ast::Unary& operation, ast::Place at);
    Operand negated(const ast::Unary& operation, const Operand& operand, ast::Place at);
    Operand binary(const ast::Binary& row);
    Operand operation(Operand left, const ast::Binary::Step& step, unsigned first);
    Operand combined(const Operand& left, Operand right, const ast::Binary::Step& step);
    Operand copied(const Operand& value, std::size_t at);
    Operand taken(const Operand& value, std::size_t at);
    Operand assignment(const ast::Assignment& assignment, ast::Place at);
    Operand computedBy(Action act, const void* a, const void* b, Kind kind, ast::Place at);

    // compile_name.cpp
    std::vector<Node> walk(const Parts& parts, std::size_t most) const;
    Operand name(const ast::Name& name, ast::Place at);
    bool variableNamed(const Parts& parts, Operand& found);
    bool valueNamed(const std::vector<Node>& nodes, const Parts& parts, Operand& found);
    bool resultNamed(const std::vector<Node>& nodes, const Parts& parts, Operand& found);
    Operand members(Operand of, const Parts& parts, std::size_t from);
    /** The declaration of the name (in an alias: before the alias); null if there is none. */
    const Scope::Entry* declared(const std::string& name) const;
    unsigned lineOfLaterFunction(const ast::Identifier& name) const;
    Operand valueOfAlias(const Scope::Entry& alias, const ast::Identifier& name);
    bool isElsewhere(const Parts& parts, const Operand& variable) const;
    bool leadsToCome(const Parts& parts) const;
    std::string missing(const Node& last, const ast::Name& name) const;
    void doubt(const Node& last, const ast::Name& name) const;
    /** True if the name may be added before the script reaches this place. */
    bool isToCome(const Node& last, const ast::Name& name) const;
    [[noreturn]] void unknownName(const std::vector<Node>& nodes, const ast::Name& name);
    std::vector<std::string> knownNames(const Node& last, bool isLast, bool called) const;
    void checkCallOfValue(const std::vector<Node>& nodes, const ast::Name& name);

    // compile_call.cpp
    Callable found(const Parts& parts, std::size_t count, const std::vector<Node>& nodes, bool toSend) const;
    Callable callable(const Parts& parts, std::size_t count, const std::vector<Node>& nodes, bool toSend) const;
    bool call(const ast::Name& name, const std::vector<Node>& nodes, ast::Place at, Operand& result);
    bool construct(const ast::Name& name, ast::Place at, Operand& result);
    Operand callOperation(const Callable& called, const ast::Name& name, ast::Place at);
    [[noreturn]] void failRecursive(const std::string& function, ast::Place at);
    Operand callFunction(const std::shared_ptr<const FunctionDefinition>& function, const ast::Name& name,
                         ast::Place at);
    /** True for the index of an argument that the call assigns to. */
    typedef std::function<bool(std::size_t)> IsOutput;
    std::vector<Operand> values(const ast::Expressions& expressions, const IsOutput& isOutput,
                                const internal::OperationSignature* signature = nullptr);
    OperationInterfacePart::Args arguments(const ast::Name& name, const OperationInterfacePart& part);
    Source argument(const ast::Name& name, const internal::OperationSignature& signature, std::size_t index,
                    const std::vector<Operand>& values);
    Source made(const ast::Name& name, ast::Place at, const OperationInterfacePart& part,
                const std::function<Source()>& make);
    /** Calls `convert` and reports conversions that lose something or are impossible. */
    template <class Convert>
    auto watched(ast::Place at, Convert convert);
    void warnOfConversion(ast::Place at, const std::string& from, const std::string& to);
    /** Warns, but not where an alias is used, because its declaration has got the warning. */
    void warn(ast::Place at, const char* code, const std::string& message, const std::string& hint = "") const;

    // compile_send.cpp
    bool handleCall(const ast::Name& name, ast::Place at, Operand& result);
    static bool givesReasons(const Callable& called);
    Source told(Source call, const Callable& called, const ast::Name& name, ast::Place at) const;
    [[noreturn]] void failUnsent(const ast::Identifier& handle);
    CallPlace placeOfCall(ast::Place at) const;
    std::shared_ptr<TrackedSend> trackedSend(const Callable& called, ast::Place at, std::shared_ptr<LastSent> last,
                                             bool forgotten);
    void sendTo(const Operand& handle, const Callable& called, const ast::Name& name, ast::Place at,
                const std::shared_ptr<TrackedSend>& told);
    Operand command(const Callable& called, const ast::Name& name, ast::Place at);
    Operand sent(const Callable& called, const ast::Name& name, ast::Place at);
    Operand sent(OperationInterfacePart& part, const ast::Name& name, ast::Place at);
    bool assignHandle(const ast::Assignment& assignment, ast::Place at, Operand& result);
    Operand sendInto(Scope::Handle& handle, const std::string& name, const ast::Expression& value, ast::Place at);

    [[noreturn]] void error(ast::Place at, const char* code, const std::string& message, const std::string& hint = "");
    oroforge::diag::Location locate(ast::Place at) const {
        return {alias_ ? alias_->file : where_.file, at.line, at.column};
    }
    std::size_t emit(Action act, const void* a = nullptr, const void* b = nullptr, void* to = nullptr);
    /** Keeps a source for instructions that refer to it. */
    base::DataSourceBase* keep(Source source);

    Compiler::State& state_;
    const CompileContext& where_;
    Code& code_;
    Scope* scope_;
    Activation* function_;
    std::vector<std::vector<std::size_t>> breaks_;  // jumps out of each loop around, without targets yet
    unsigned executions_ = 0;                       // number of calls, and of assignments inside expressions
    unsigned aliases_ = 0;                          // number of aliases being resolved
    const ast::Name* text_ = nullptr;               // an argument that must be a text
    std::set<const ast::Name*> ignored_;            // calls whose value is ignored
    const Scope::Entry* alias_ = nullptr;           // the innermost alias
    const ast::Identifier* used_alias_ = nullptr;   // the outermost alias
    unsigned alias_uses_ = 0;                       // number of aliases used in that one
};

template <class Convert>
auto UnitCompiler::watched(ast::Place at, Convert convert) {
    const types::detail::ConversionWatch watch;
    const types::detail::RefusalWatch refusals;
    auto made = convert();
    for (const auto& conversion : watch.conversions()) warnOfConversion(at, conversion.from, conversion.to);
    if (!refusals.reason().empty()) error(at, "OPS154", refusals.reason());
    return made;
}

}  // namespace RTT::scripting::detail

#endif
