// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The common part of running and checking a script: its items, its definitions and its errors.
#ifndef ORO_SCRIPTING_DETAIL_SCRIPT_READER_HPP
#define ORO_SCRIPTING_DETAIL_SCRIPT_READER_HPP

#include <rtt/scripting/detail/compile/definitions.hpp>
#include <rtt/scripting/detail/compile/source_file.hpp>

#include <diag/sink.hpp>

#include <map>
#include <memory>
#include <string>

namespace RTT::scripting::detail {

/** Why a program or state machine cannot be loaded: a `kind` already has its name. */
std::string nameTaken(const TaskContext& component, const char* kind);

/** For one text, in one thread. */
class ScriptReader {
public:
    ScriptReader(TaskContext& component, std::shared_ptr<SourceFile> file);
    virtual ~ScriptReader();
    ScriptReader(const ScriptReader&) = delete;
    ScriptReader& operator=(const ScriptReader&) = delete;

protected:
    // Handles an item; false, with errors in the sink, if it cannot be used.
    virtual bool take(const ast::Item& item, const ast::StatementPtr& statement) = 0;
    virtual bool take(const ast::Item& item, const ast::Function& function) = 0;
    virtual bool take(const ast::Item& item, const ast::Program& program) = 0;
    virtual bool take(const ast::Item& item, const ast::StateMachine& type) = 0;
    virtual bool take(const ast::Item& item, const ast::Instance& machine) = 0;
    bool take(const ast::Item& item);

    /** Parses the file; false after syntax errors. */
    bool parse();
    /** Reports an error and returns false if the text has defined the name already. */
    bool isNew(const char* kind, const char* code, const ast::Identifier& name);
    /** True if the text has defined the name already; adds a note with the place to `*error` unless that is null. */
    bool hasDefined(const char* kind, const std::string& name, oroforge::diag::Diagnostic* error = nullptr) const;
    /** The function may call what is defined now, even after redefinitions. */
    std::shared_ptr<const FunctionDefinition> definitionOf(const ast::Item& item, const ast::Function& function,
                                                           const Functions& known) const;
    std::shared_ptr<const MachineType> typeOf(const ast::Item& item, const ast::StateMachine& type) const;

    /** Executes the code to its end, with a short wait after yields. Reports an error and returns false if it fails or
        yields for too long. */
    bool execute(const Code& code);

    CompileContext context(ExecutionEngine* caller);
    CompileContext atTopLevel();
    /** The context for code that the component's engine executes and that may call these functions, which must outlive
        its use. */
    CompileContext inEngine(const Functions& functions);
    oroforge::diag::Location at(ast::Place place) const { return {file_->name, place.line, place.column}; }
    oroforge::diag::Diagnostic& error(ast::Place place, const char* code, const std::string& message);
    /** "program 'p' cannot be loaded: …" */
    oroforge::diag::Diagnostic& refuse(const char* kind, const char* code, const ast::Identifier& name,
                                       const std::string& why);

    TaskContext& component_;
    const std::shared_ptr<SourceFile> file_;
    oroforge::diag::Sink sink_;
    const std::shared_ptr<SentCalls> sent_ = std::make_shared<SentCalls>();
    Compiler compiler_;  // for the statements between the definitions

private:
    std::map<std::string, ast::Place> defined_;  // with the kind before the name
};

}  // namespace RTT::scripting::detail

#endif
