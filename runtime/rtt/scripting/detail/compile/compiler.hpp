// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Tree to code: looks every name up, checks every type, and reports what does not fit.
#ifndef ORO_SCRIPTING_DETAIL_COMPILER_HPP
#define ORO_SCRIPTING_DETAIL_COMPILER_HPP

#include <rtt/internal/DataSource.hpp>
#include <rtt/scripting/detail/syntax/ast.hpp>
#include <rtt/scripting/detail/execute/code.hpp>
#include <rtt/scripting/detail/execute/peers.hpp>
#include <rtt/scripting/detail/execute/process.hpp>
#include <rtt/scripting/detail/compile/told_send.hpp>

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

/** The declarations of a script, a program, a function, a state machine or a state. A function may be compiled by any thread
    while its script goes on and declares more: what is found here stays as and where it is. */
class Scope {
public:
    /** What a `var SendHandle` refers to, from its first assignment on. Thread safe, since functions are. */
    class Handle {
    public:
        /** Null before. */
        boost::shared_ptr<const OperationInterfacePart> operation() const;
        base::DataSourceBase::shared_ptr source() const;
        void set(boost::shared_ptr<const OperationInterfacePart> operation, base::DataSourceBase::shared_ptr source);
        void clear() { set(nullptr, nullptr); }
        /** The call that was sent with it last, for reporting its failure. */
        const std::shared_ptr<LastSent>& lastSent() const { return last_sent_; }

    private:
        mutable std::mutex mutex_;
        boost::shared_ptr<const OperationInterfacePart> operation_;
        base::DataSourceBase::shared_ptr source_;
        const std::shared_ptr<LastSent> last_sent_ = std::make_shared<LastSent>();
    };
    /** When something was declared: later ones are greater, whatever their scopes. */
    typedef std::uint64_t Time;
    static Time now();
    static constexpr Time kEver = ~Time{0};

    struct Entry {
        base::DataSourceBase::shared_ptr source;  ///< null for an alias and a handle
        bool constant = false;
        const ast::Expression* alias = nullptr;  ///< compiled with each use, in `scope`, by what was declared before it
        const Scope* scope = nullptr;
        oroforge::diag::FileName file;  ///< of an alias
        Time declared = 0;              ///< set when it is added
        std::shared_ptr<Handle> handle;
        ast::Place at;
        /** Of a variable that the head of a `for` declared: later loops may use it again. */
        enum class Loop { No, Entered, Left } loop = Loop::No;
    };
    /** `name` is for messages: "program 'p'". Of the parent, it sees what was declared before `since`. */
    explicit Scope(std::string name, const Scope* parent = nullptr, Time since = kEver)
        : name_(std::move(name)), parent_(parent), since_(since) {}
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

    const std::string& name() const { return name_; }
    const Scope* parent() const { return parent_; }
    /** Here or in a parent, declared before `since`; null if there is none. */
    const Entry* find(const std::string& name, Time since = kEver) const;
    const Entry* findHere(const std::string& name) const;
    void markLoop(const std::string& name, Entry::Loop loop);
    /** False if there is one here. */
    bool add(const std::string& name, Entry entry);
    /** Those of now. */
    std::map<std::string, Entry> entries() const;
    /** The text of which it has the variables between the items; null for all others. */
    const ast::Script* script() const { return script_; }
    void belongsTo(const ast::Script& script) { script_ = &script; }

private:
    std::string name_;
    const Scope* parent_;
    Time since_;
    const ast::Script* script_ = nullptr;
    mutable std::mutex mutex_;  // of the map, held for no longer than it is looked at
    std::map<std::string, Entry> entries_;
};

/** A function that scripts defined. Shared, because programs that use it may outlive its definition. */
struct FunctionDefinition {
    std::string name;
    std::shared_ptr<const ast::Function> tree;
    std::shared_ptr<const Scope> scope;  ///< of the file it stands in
    oroforge::diag::FileName file;
    std::shared_ptr<const std::string> text;  ///< of the file
    Scope::Time defined = Scope::now();       ///< it sees what was declared before
    // Known once it has been checked, before others know it.
    mutable std::vector<std::shared_ptr<const FunctionDefinition>> calls;
    mutable std::size_t size = 1;  ///< how many functions are to be compiled for it, at most
    /** Those it may call. Null: those that its caller may call. */
    std::shared_ptr<const std::map<std::string, std::shared_ptr<const FunctionDefinition>>> functions;
};
typedef std::map<std::string, std::shared_ptr<const FunctionDefinition>> Functions;

/** What is not there while a script is checked, and may be when it runs. */
class NamesToCome {
public:
    virtual ~NamesToCome() = default;
    /** True if `owner`, or whatever belongs to it, may have that name then; null: what belongs to no component. `isFirst`: it
        is the first part of a path, so that it may be global as well. */
    virtual bool mayHave(const TaskContext* owner, const std::string& name, bool isFirst) = 0;
    /** True if a component of that name, of which nothing else is known, will be a peer then. */
    virtual bool isToCome(const std::string& peer) = 0;
    /** True if that function, of this script or of one before, may be another one then. */
    virtual bool mayReplace(const std::string& function, bool isOfThis) = 0;
    /** Whether names that may be there then are to be doubted if they are like names that are there now. */
    virtual bool tellsDoubts() const = 0;
    /** That name was not declared, for a reason that is known. */
    virtual void miss(const std::string& name) = 0;
    /** How often one of the first three was true: as often something was not compiled, which is no error. */
    unsigned gaps = 0;
};

/** Where a piece of script belongs. */
struct Surroundings {
    TaskContext* component = nullptr;
    ExecutionEngine* caller = nullptr;     ///< of the operations it calls
    const Functions* functions = nullptr;  ///< of the component, callable by name in its own engine
    const Functions* known = nullptr;      ///< more of them, whose names are for messages; or null
    Service* service = nullptr;            ///< of a state machine: where paths are looked up first; or null
    oroforge::diag::FileName file;
    std::shared_ptr<const std::string> text;  ///< of the file, for messages at run time; or null
    oroforge::diag::Sink* sink = nullptr;
    /** How often loops of a program, function or state machine may go round in one step (0: no limit); read in each step.
        Null without limit. */
    boost::intrusive_ptr<internal::DataSource<unsigned int>> roundLimit;
    bool checkOnly = false;           ///< nothing is evaluated while it is compiled
    NamesToCome* toCome = nullptr;    ///< of a check; or null
    std::shared_ptr<SentCalls> sent;  ///< gets what statements send; or null
    /** Gets those it refers to, for the process that executes it; or null. */
    std::shared_ptr<Peers> peers;
};

/**
 * Compiles pieces of one root: everything compiled by one Compiler may share activations of functions, so it must belong
 * to one Process, or to several of which only one is between its beginning and its end at any time.
 *
 * Every error is reported to the sink; then null is returned. Allocates; not thread safe.
 */
class Compiler {
public:
    explicit Compiler(Surroundings surroundings);
    ~Compiler();

    /** The statements, with their variables in a scope of their own in `scope` (which must be alive only during the call,
        unless it has aliases). */
    std::unique_ptr<Code> program(const ast::Block& block, const std::string& name, const Scope& scope);
    /** One statement of a file: declarations go to `scope`. */
    std::unique_ptr<Code> statement(const ast::Statement& statement, Scope& scope);
    /** Declarations; the code assigns the initial values. */
    std::unique_ptr<Code> declarations(const std::vector<ast::StatementPtr>& declarations, Scope& scope);
    /** Code that assigns the value to `to`, converted if necessary. `what` is for messages: "parameter 'p'". */
    std::unique_ptr<Code> assignment(base::DataSourceBase::shared_ptr to, const ast::Expression& value,
                                     const std::string& what, const Scope& scope);
    /** Code that leaves its truth at `*result`, which the code owns. */
    std::unique_ptr<Code> condition(const ast::Expression& expression, const Scope& scope, const bool*& result);
    /** A variable that can be assigned to, such as an argument of an event; null if it is none. */
    base::DataSourceBase::shared_ptr variable(const ast::Expression& expression, const Scope& scope);
    /** The function itself, for those who call it from outside of a script. */
    std::unique_ptr<Activation> function(const FunctionDefinition& definition);
    /** Reports errors and warnings of the function itself; those it calls are known by what they take and give, and nothing is
        evaluated. What is returned has arguments and result of the right types, and cannot be executed. Sets `calls` and `size`. */
    std::unique_ptr<Activation> check(const FunctionDefinition& definition);

    struct State;

private:
    std::unique_ptr<State> state_;
};

}  // namespace detail
}  // namespace scripting
}  // namespace RTT

#endif
