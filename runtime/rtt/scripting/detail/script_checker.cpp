// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/script_checker.hpp>

#include <rtt/TaskContext.hpp>
#include <rtt/scripting/ScriptingService.hpp>
#include <rtt/scripting/detail/find_calls.hpp>
#include <rtt/scripting/detail/function_operation.hpp>
#include <rtt/scripting/detail/loaded.hpp>
#include <rtt/scripting/detail/machine_build.hpp>
#include <rtt/scripting/detail/program.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace RTT {
namespace scripting {
namespace detail {

namespace diag = oroforge::diag;

namespace {

const char* const kProgram = "program";
const char* const kMachine = "state machine";

/** Of errors that are none if somebody adds a name in time. */
const char* const kUnknownNames[] = {"OPS110", "OPS132", "OPS133", "OPS134", "OPS146",
                                     "OPS148", "OPS305", "OPS311", "OPS312", "OPS317"};

bool isAboutNames(const diag::Diagnostic& error) {
    return std::find(std::begin(kUnknownNames), std::end(kUnknownNames), error.code) != std::end(kUnknownNames);
}

}  // namespace

ScriptChecker::ScriptChecker(TaskContext& component, std::shared_ptr<SourceFile> file)
    : ScriptReader(component, std::move(file)) {}

ScriptChecker::~ScriptChecker() {
    for (const std::string& name : services_) component_.provides()->removeService(name);
}

diag::Sink ScriptChecker::check() {
    diag::Sink found;
    const bool parsed = parse();
    keepWhatIsCertain(found);
    if (!parsed) return found;
    for (const ast::Item& item : file_->tree.items) {
        const bool good = take(item);
        keepWhatIsCertain(found);
        const auto* const statement = std::get_if<ast::StatementPtr>(&item.what);
        // What could not be made is missed by what follows, which is no error of its own.
        if (!good || (statement && mayCall(**statement))) names_are_known_ = false;
    }
    return found;
}

void ScriptChecker::keepWhatIsCertain(diag::Sink& found) {
    for (const diag::Diagnostic& each : sink_.all())
        if (names_are_known_ || !isAboutNames(each)) found.add(each);
    sink_ = {};
}

Surroundings ScriptChecker::unevaluated(const Functions& functions) {
    Surroundings where = inEngine(functions);
    where.checkOnly = true;
    return where;
}

bool ScriptChecker::take(const ast::Item&, const ast::StatementPtr& statement) {
    const auto functions = definitions_.functions();
    return Compiler(unevaluated(*functions)).statement(*statement, file_->scope) != nullptr;
}

bool ScriptChecker::isFree(const char* kind, const char* code, const ast::Identifier& name) {
    if (!isNew(kind, code, name)) return false;
    const char* const other = kind == kProgram ? kMachine : kProgram;
    if (hasDefined(other, name.text)) {
        hasDefined(other, name.text, &refuse(kind, code, name, nameTaken(component_, other)));
        return false;
    }
    // A component that has run this script may have it looked through again.
    const auto scripting =
        boost::dynamic_pointer_cast<ScriptingService>(component_.provides()->getService("scripting"));
    const bool scripted = scripting && (scripting->hasProgram(name.text) || scripting->hasStateMachine(name.text));
    if (scripted || !names_are_known_ || !component_.provides()->hasService(name.text)) return true;
    refuse(kind, code, name, nameTaken(component_, "service"));
    return false;
}

bool ScriptChecker::take(const ast::Item& item, const ast::Function& function) {
    if (!isNew("function", "OPS201", function.name)) return false;
    auto functions = definitions_.functions();
    auto definition = definitionOf(item, function, *functions);
    const Surroundings where = unevaluated(*functions);
    Service* const scripting = component_.provides()->getService("scripting").get();
    // Unless a statement before may have removed the other one.
    if (names_are_known_ && !hasFreeName(*definition, function.scope, scripting, where)) return false;
    if (!Compiler(where).check(*definition)) return false;
    functions.reset();  // else it is copied
    definitions_.define(std::move(definition));
    return true;
}

bool ScriptChecker::take(const ast::Item& item, const ast::Program& program) {
    if (!isFree(kProgram, "OPS203", program.name)) return false;
    const auto functions = definitions_.functions();
    const ProgramInterfacePtr made = makeProgram(program, *file_, file_->textOf(item), unevaluated(*functions));
    if (!made || component_.provides()->hasService(made->getName())) return made != nullptr;
    services_.push_back(made->getName());
    return component_.provides()->addService(makeProgramService(made, component_));
}

bool ScriptChecker::take(const ast::Item& item, const ast::StateMachine& type) {
    if (!isNew("state machine type", "OPS301", type.type)) return false;
    auto made = typeOf(item, type);
    const auto functions = definitions_.functions();
    if (!checkMachineType(*made, *definitions_.machineTypes(), unevaluated(*functions))) return false;
    definitions_.define(std::move(made));
    return true;
}

bool ScriptChecker::take(const ast::Item&, const ast::Instance& machine) {
    if (!isFree(kMachine, "OPS303", machine.name)) return false;
    if (component_.provides()->hasService(machine.name.text)) return true;
    const auto functions = definitions_.functions();
    if (!makeMachine(machine, *definitions_.machineTypes(), *file_, unevaluated(*functions))) return false;
    services_.push_back(machine.name.text);
    return true;
}

}  // namespace detail
}  // namespace scripting
}  // namespace RTT
