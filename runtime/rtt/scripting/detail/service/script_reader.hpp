// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What running and checking a script have in common: its text as items, what it defines, and its errors.
#ifndef ORO_SCRIPTING_DETAIL_SCRIPT_READER_HPP
#define ORO_SCRIPTING_DETAIL_SCRIPT_READER_HPP

#include <rtt/scripting/detail/compile/definitions.hpp>
#include <rtt/scripting/detail/compile/source_file.hpp>

#include <diag/sink.hpp>

#include <map>
#include <memory>
#include <string>

namespace RTT::scripting::detail {

/** Why a program or state machine cannot be loaded: what has its name already is a `kind`. */
std::string nameTaken(const TaskContext& component, const char* kind);

/** For one text, in one thread. */
class ScriptReader {
public:
    ScriptReader(TaskContext& component, std::shared_ptr<SourceFile> file);
    virtual ~ScriptReader();
    ScriptReader(const ScriptReader&) = delete;
    ScriptReader& operator=(const ScriptReader&) = delete;

protected:
    // One item; false if it cannot be used, with the errors in the sink.
    virtual bool take(const ast::Item& item, const ast::StatementPtr& statement) = 0;
    virtual bool take(const ast::Item& item, const ast::Function& function) = 0;
    virtual bool take(const ast::Item& item, const ast::Program& program) = 0;
    virtual bool take(const ast::Item& item, const ast::StateMachine& type) = 0;
    virtual bool take(const ast::Item& item, const ast::Instance& machine) = 0;
    bool take(const ast::Item& item);

    /** Makes the tree of the file; false after syntax errors. */
    bool parse();
    /** False, with an error, if the text has defined it already. */
    bool isNew(const char* kind, const char* code, const ast::Identifier& name);
    /** True if it has defined that already; where, is noted at `*error` unless that is null. */
    bool hasDefined(const char* kind, const std::string& name, oroforge::diag::Diagnostic* error = nullptr) const;
    /** It may call what is known now, and goes on calling that. */
    std::shared_ptr<const FunctionDefinition> definitionOf(const ast::Item& item, const ast::Function& function,
                                                           const Functions& known) const;
    std::shared_ptr<const MachineType> typeOf(const ast::Item& item, const ast::StateMachine& type) const;

    /** To its end; false, with an error, if it fails or yields for too long. Waits a little between yields. */
    bool execute(const Code& code);

    Surroundings surroundings(ExecutionEngine* caller);
    Surroundings atTopLevel();
    /** Of what is executed by the component's engine and may call these functions, which stay alive as long as it is used. */
    Surroundings inEngine(const Functions& functions);
    oroforge::diag::Location at(ast::Place place) const { return {file_->name, place.line, place.column}; }
    oroforge::diag::Diagnostic& error(ast::Place place, const char* code, const std::string& message);
    /** "program 'p' cannot be loaded: …" */
    oroforge::diag::Diagnostic& refuse(const char* kind, const char* code, const ast::Identifier& name,
                                       const std::string& why);

    TaskContext& component_;
    const std::shared_ptr<SourceFile> file_;
    oroforge::diag::Sink sink_;
    const std::shared_ptr<SentCalls> sent_ = std::make_shared<SentCalls>();
    Compiler compiler_;  // of the statements between the definitions

private:
    std::map<std::string, ast::Place> defined_;  // with the kind before the name
};

}  // namespace RTT::scripting::detail

#endif
