// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/service/script_runner.hpp>

#include <rtt/TaskContext.hpp>
#include <rtt/scripting/ScriptingService.hpp>
#include <rtt/scripting/detail/function/function_operation.hpp>
#include <rtt/scripting/detail/service/loaded.hpp>
#include <rtt/scripting/detail/execute/log_diagnostics.hpp>
#include <rtt/scripting/detail/machine/machine_build.hpp>
#include <rtt/scripting/detail/execute/program.hpp>
#include <rtt/scripting/detail/service/script_contents.hpp>

#include <diag/print.hpp>

#include <filesystem>
#include <utility>

namespace RTT::scripting::detail {

namespace diag = oroforge::diag;

namespace {

constexpr unsigned kDeepest = 50;

thread_local const ScriptRunner* innermost = nullptr;
// Scripts were nested too deeply. All of them end, because each might try again and again.
thread_local bool unwinding = false;

}  // namespace

ScriptRunner::ScriptRunner(ScriptingService& service, diag::FileName name, std::string text)
    : ScriptReader(*service.getOwner(),
                   std::make_shared<SourceFile>(std::move(name), std::move(text), runningIn(service))),
      service_(service),
      outer_(innermost),
      depth_(outer_ ? outer_->depth_ + 1 : 1) {
    innermost = this;
}

ScriptRunner::~ScriptRunner() {
    innermost = outer_;
    if (!outer_) unwinding = false;
    letGoOfFunctions(file_->scope);
}

bool ScriptRunner::isUnwinding() { return unwinding; }

SourceFilePtr ScriptRunner::runningIn(const ScriptingService& service) {
    const ScriptRunner* runner = innermost;
    while (runner && &runner->service_ != &service) runner = runner->outer_;
    return runner ? runner->file_ : nullptr;
}

std::string ScriptRunner::locate(const std::string& file) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path path = file;
    if (!innermost || path.is_absolute() || fs::exists(path, ignored)) return file;
    const fs::path beside = fs::path(innermost->file_->name.str()).parent_path() / path;
    return fs::exists(beside, ignored) ? beside.string() : file;
}

bool ScriptRunner::run(Contents contents) {
    if (checkDepth() && parse()) checkContents(contents);
    bool good = !sink_.hadErrors();
    report();
    for (auto item = file_->tree.items.begin(); good && item != file_->tree.items.end(); ++item) {
        good = take(*item) && !unwinding;
        report();
    }
    good = sent_->settle() && good;
    if (!good && contents != Contents::Everything) unload();
    return good;
}

bool ScriptRunner::checkDepth() {
    if (depth_ <= kDeepest) return true;
    error({}, "OPS414", "scripts run each other more than " + std::to_string(kDeepest) + " deep");
    unwinding = true;
    return false;
}

void ScriptRunner::unload() {
    for (const std::string& name : programs_) service_.takeOutProgram(name);
    for (const std::string& name : machines_)
        if (StateMachinePtr machine = service_.getStateMachine(name)) service_.takeOutMachine(std::move(machine));
}

bool ScriptRunner::take(const ast::Item&, const ast::StatementPtr& statement) {
    const std::unique_ptr<Code> code = compiler_.statement(*statement, file_->scope);
    return code && execute(*code);
}

bool ScriptRunner::take(const ast::Item& item, const ast::Function& function) {
    if (!isNew("function", "OPS201", function.name)) return false;
    auto functions = service_.loaded_->definitions.functions();
    auto definition = definitionOf(item, function, *functions);
    if (!addFunction(definition, function.scope, service_, limited(*functions))) return false;
    functions.reset();  // otherwise it would be copied
    service_.loaded_->definitions.define(std::move(definition));
    return true;
}

bool ScriptRunner::take(const ast::Item& item, const ast::Program& program) {
    if (!isFree("program", "OPS203", program.name)) return false;
    const auto functions = service_.loaded_->definitions.functions();
    const ProgramInterfacePtr made =
        makeProgram(program, *file_, file_->withComment(item).letters, limited(*functions));
    if (!made || !service_.loadProgram(made)) return false;
    programs_.push_back(made->getName());
    return true;
}

bool ScriptRunner::take(const ast::Item& item, const ast::StateMachine& type) {
    if (!isNew("state machine type", "OPS301", type.type)) return false;
    auto made = typeOf(item, type);
    Definitions& definitions = service_.loaded_->definitions;
    const auto functions = definitions.functions();
    if (!checkMachineType(*made, *definitions.machineTypes(), limited(*functions))) return false;
    definitions.define(std::move(made));
    return true;
}

bool ScriptRunner::take(const ast::Item&, const ast::Instance& machine) {
    if (!isFree("state machine", "OPS303", machine.name)) return false;
    const Definitions& definitions = service_.loaded_->definitions;
    const auto functions = definitions.functions();
    const StateMachinePtr made = makeMachine(machine, *definitions.machineTypes(), *file_, limited(*functions));
    if (!made || !service_.loadStateMachine(made)) return false;
    machines_.push_back(made->getName());
    return true;
}

void ScriptRunner::checkContents(Contents contents) {
    detail::checkContents(file_->tree.items, contents,
                          [this](ast::Place at, const char* code, const std::string& text) { error(at, code, text); });
}

bool ScriptRunner::isFree(const char* kind, const char* code, const ast::Identifier& name) {
    const std::string taken = service_.nameInUse(name.text);
    if (taken.empty()) return true;
    refuse(kind, code, name, taken);
    return false;
}

CompileContext ScriptRunner::limited(const Functions& functions) {
    CompileContext where = inEngine(functions);
    where.roundLimit = service_.loaded_->roundLimit();
    return where;
}

void ScriptRunner::report() {
    if (sink_.empty()) return;
    diag::SourceCache sources;
    for (const SourceFile* file = file_.get(); file; file = file->caller.get()) sources.add(file->name, file->text);
    logDiagnostics(sink_, sources);
    if (first_error_.empty() && sink_.hadErrors()) first_error_ = diag::toString(sink_.all().front());
    sink_ = {};
}

}  // namespace RTT::scripting::detail
