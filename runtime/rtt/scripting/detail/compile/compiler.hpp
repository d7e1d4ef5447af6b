// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Compiles trees to code: resolves names, checks types, and reports errors.
#ifndef ORO_SCRIPTING_DETAIL_COMPILER_HPP
#define ORO_SCRIPTING_DETAIL_COMPILER_HPP

#include <rtt/internal/DataSource.hpp>
#include <rtt/scripting/detail/syntax/ast.hpp>
#include <rtt/scripting/detail/execute/code.hpp>
#include <rtt/scripting/detail/execute/peers.hpp>
#include <rtt/scripting/detail/execute/process.hpp>
#include <rtt/scripting/detail/compile/tracked_send.hpp>

#include <diag/sink.hpp>

#include <boost/shared_ptr.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace RTT {
class ExecutionEngine;
class OperationInterfacePart;
class Service;
class TaskContext;
namespace scripting {
namespace detail {

/** The declarations of a script, program, function, state machine or state. Any thread may compile a function while its
    script goes on and declares more, so entries neither change nor move. */
class Scope {
public:
    /** What a `var SendHandle` refers to, from its first assignment on. Thread safe, as functions are. */
    class Handle {
    public:
        /** The operation; null before the first assignment. */
        boost::shared_ptr<const OperationInterfacePart> operation() const;
        base::DataSourceBase::shared_ptr source() const;
        void set(boost::shared_ptr<const OperationInterfacePart> operation, base::DataSourceBase::shared_ptr source);
        void clear() { set(nullptr, nullptr); }
        /** The last call sent with it, to report its failure. */
        const std::shared_ptr<LastSent>& lastSent() const { return last_sent_; }

    private:
        mutable std::mutex mutex_;
        boost::shared_ptr<const OperationInterfacePart> operation_;
        base::DataSourceBase::shared_ptr source_;
        const std::shared_ptr<LastSent> last_sent_ = std::make_shared<LastSent>();
    };
    /** The time of a declaration; it increases across all scopes. */
    typedef std::uint64_t Time;
    static Time now();
    static constexpr Time kEver = ~Time{0};

    struct Entry {
        base::DataSourceBase::shared_ptr source;  ///< null for an alias and a handle
        bool constant = false;
        const ast::Expression* alias = nullptr;  ///< compiled at each use, in `scope`, with what was declared before it
        const Scope* scope = nullptr;
        oroforge::diag::FileName file;  ///< the file of an alias
        Time declared = 0;              ///< set when it is added
        std::shared_ptr<Handle> handle;
        ast::Place at;
        /** The state of a variable declared in the head of a `for`, which later loops may use again. */
        enum class Loop { No, Entered, Left } loop = Loop::No;
    };
    /** `name` is for messages: "program 'p'". Sees what the parent declared before `since`. */
    explicit Scope(std::string name, const Scope* parent = nullptr, Time since = kEver)
        : name_(std::move(name)), parent_(parent), since_(since) {}
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

    const std::string& name() const { return name_; }
    const Scope* parent() const { return parent_; }
    /** The entry, here or in a parent, that was declared before `since`; null if there is none. */
    const Entry* find(const std::string& name, Time since = kEver) const;
    const Entry* findHere(const std::string& name) const;
    void markLoop(const std::string& name, Entry::Loop loop);
    /** Adds an entry; false if this scope has one of that name. */
    bool add(const std::string& name, Entry entry);
    /** A snapshot of the entries. */
    std::map<std::string, Entry> entries() const;
    /** The script whose top-level variables it has; null for other scopes. */
    const ast::Script* script() const { return script_; }
    void belongsTo(const ast::Script& script) { script_ = &script; }

private:
    std::string name_;
    const Scope* parent_;
    Time since_;
    const ast::Script* script_ = nullptr;
    mutable std::mutex mutex_;  // guards the map; held only for look-ups
    std::map<std::string, Entry> entries_;
};

/** A function defined by a script. Shared, because programs that use it may outlive its definition. */
struct FunctionDefinition {
    std::string name;
    std::shared_ptr<const ast::Function> tree;
    std::shared_ptr<const Scope> scope;  ///< the scope of its file
    oroforge::diag::FileName file;
    std::shared_ptr<const std::string> text;  ///< the text of its file
    Scope::Time defined = Scope::now();       ///< it sees what was declared before
    // Set when it has been checked, before other threads know the function.
    mutable std::vector<std::shared_ptr<const FunctionDefinition>> calls;
    mutable std::size_t size = 1;  ///< the most functions that must be compiled for it
    /** The functions that it may call; null: those that its caller may call. */
    std::shared_ptr<const std::map<std::string, std::shared_ptr<const FunctionDefinition>>> functions;
};
typedef std::map<std::string, std::shared_ptr<const FunctionDefinition>> Functions;

/** Names that do not exist while a script is checked but may exist when it runs. */
class NamesToCome {
public:
    virtual ~NamesToCome() = default;
    /** True if `owner` or what belongs to it may get that name; null means global. `isFirst`: it is the first part of a
        path, so it may be global, too. */
    virtual bool mayHave(const TaskContext* owner, const std::string& name, bool isFirst) = 0;
    /** True if a component of that name, with an unknown interface, will be a peer. */
    virtual bool isToCome(const std::string& peer) = 0;
    /** True if that function, of this script or an earlier one, may be replaced. */
    virtual bool mayReplace(const std::string& function, bool isOfThis) = 0;
    /** True if names that may exist later give a warning if they are similar to existing names. */
    virtual bool tellsDoubts() const = 0;
    /** Notes that the name was not declared, for a known reason. */
    virtual void miss(const std::string& name) = 0;
    /** How often one of the first three functions was true: then something was not compiled, which is not an error. */
    unsigned gaps = 0;
};

/** The environment in which a piece of script is compiled. */
struct CompileContext {
    TaskContext* component = nullptr;
    ExecutionEngine* caller = nullptr;     ///< the engine that calls operations
    const Functions* functions = nullptr;  ///< functions of the component, callable by name in its own engine
    const Functions* known = nullptr;      ///< more functions, whose names are for messages; or null
    Service* service = nullptr;            ///< the service of a state machine, where paths are looked up first; or null
    oroforge::diag::FileName file;
    std::shared_ptr<const std::string> text;  ///< the text of the file, for messages at run time; or null
    oroforge::diag::Sink* sink = nullptr;
    /** How many rounds the loops of a program, function or state machine may make in one step (0: no limit); read in
        each step. Null if there is no limit. */
    boost::intrusive_ptr<internal::DataSource<unsigned int>> roundLimit;
    bool checkOnly = false;           ///< nothing is evaluated while it is compiled
    NamesToCome* toCome = nullptr;    ///< for a check; or null
    std::shared_ptr<SentCalls> sent;  ///< gets what statements send; or null
    /** Gets the peers that the code refers to, for the process that executes it; or null. */
    std::shared_ptr<Peers> peers;
};

/**
 * Compiles pieces of one root. Code compiled by one Compiler may share activations of functions, so it must belong to
 * one Process, or to several of which only one is started at any time.
 *
 * Functions report errors to the sink and then return null. Allocates; not thread safe.
 */
class Compiler {
public:
    explicit Compiler(CompileContext context);
    ~Compiler();

    /** The statements, with their variables in a new scope inside `scope` (which must outlive the call only if it has
        aliases). */
    std::unique_ptr<Code> program(const ast::Block& block, const std::string& name, const Scope& scope);
    /** One statement of a file: declarations go to `scope`. */
    std::unique_ptr<Code> statement(const ast::Statement& statement, Scope& scope);
    /** Declarations; the code assigns the initial values. */
    std::unique_ptr<Code> declarations(const std::vector<ast::StatementPtr>& declarations, Scope& scope);
    /** Code that assigns the value to `to`, converted if necessary. `what` is for messages: "parameter 'p'". */
    std::unique_ptr<Code> assignment(base::DataSourceBase::shared_ptr to, const ast::Expression& value,
                                     const std::string& what, const Scope& scope);
    /** Code that evaluates the expression. After that `result` has a copy of the value; the source of the expression
        itself if its type has no variables, null if there is no value. */
    std::unique_ptr<Code> value(const ast::Expression& expression, Scope& scope,
                                base::DataSourceBase::shared_ptr& result);
    /** Code that leaves its truth at `*result`, which the code owns. */
    std::unique_ptr<Code> condition(const ast::Expression& expression, const Scope& scope, const bool*& result);
    /** A variable that can be assigned, such as an argument of an event; null if the expression is something else. */
    base::DataSourceBase::shared_ptr variable(const ast::Expression& expression, const Scope& scope);
    /** The function itself, for callers outside of scripts. */
    std::unique_ptr<Activation> function(const FunctionDefinition& definition);
    /** Reports errors and warnings of the function, without compiling those that it calls or evaluating anything. The
        result has arguments and result of the right types but cannot be executed. Sets `calls` and `size`. */
    std::unique_ptr<Activation> check(const FunctionDefinition& definition);

    struct State;

private:
    std::unique_ptr<State> state_;
};

}  // namespace detail
}  // namespace scripting
}  // namespace RTT

#endif
