// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/service/script_checker.hpp>

#include <rtt/TaskContext.hpp>
#include <rtt/scripting/ScriptingService.hpp>
#include <rtt/scripting/detail/compile/find_calls.hpp>
#include <rtt/scripting/detail/function/function_operation.hpp>
#include <rtt/scripting/detail/service/loaded.hpp>
#include <rtt/scripting/detail/machine/machine_build.hpp>
#include <rtt/scripting/detail/execute/program.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace RTT::scripting::detail {

namespace diag = oroforge::diag;

namespace {

const char* const kProgram = "program";
const char* const kMachine = "state machine";

/** Codes of errors that vanish if a name or type is added in time. */
const char* const kUnknownNames[] = {"OPS110", "OPS132", "OPS133", "OPS134", "OPS146",
                                     "OPS148", "OPS305", "OPS311", "OPS312", "OPS317"};
const char* const kUnknownTypes[] = {"OPS110", "OPS146", "OPS317"};

/** The name that the item defines for the component; null if it defines none. */
const std::string* definedBy(const ast::Item& item) {
    if (const auto* const function = std::get_if<ast::Function>(&item.what)) return &function->name.text;
    if (const auto* const program = std::get_if<ast::Program>(&item.what)) return &program->name.text;
    if (const auto* const type = std::get_if<ast::StateMachine>(&item.what)) return &type->type.text;
    if (const auto* const machine = std::get_if<ast::Instance>(&item.what)) return &machine->name.text;
    return nullptr;
}

/** True if it waits only for its calls. */
bool isPlain(const ast::Statement& statement) {
    return std::holds_alternative<ast::Declaration>(statement.what) ||
           std::holds_alternative<ast::Do>(statement.what) || std::holds_alternative<ast::Try>(statement.what);
}

template <std::size_t N>
bool isOneOf(const char* const (&codes)[N], const diag::Diagnostic& error) {
    return std::find(std::begin(codes), std::end(codes), error.code) != std::end(codes);
}

}  // namespace

ScriptChecker::ScriptChecker(TaskContext& component, std::shared_ptr<SourceFile> file, CallForecast& forecast,
                             Expectations& expected)
    : ScriptReader(component, std::move(file)), forecast_(forecast), expected_(expected) {}

ScriptChecker::ScriptChecker(ScriptChecker& outer, std::shared_ptr<SourceFile> file, bool certain)
    : ScriptReader(outer.component_, std::move(file)),
      outer_(&outer),
      certain_(certain && outer.certain_),
      forecast_(outer.forecast_),
      expected_(outer.expected_) {}

ScriptChecker::~ScriptChecker() {
    for (const auto& [service, name] : operations_) service->removeOperation(name);
    for (const std::string& name : services_) component_.provides()->removeService(name);
    letGoOfFunctions(file_->scope);
}

diag::Sink ScriptChecker::check() {
    diag::Sink found;
    const bool parsed = parse();
    keepWhatIsCertain(found);
    if (!parsed) return found;
    for (const ast::Item& item : file_->tree.items) {
        const bool good = take(item);
        const std::size_t errors = found.errorCount();
        keepWhatIsCertain(found);
        if (!good) missWhatIsDefinedBy(item);
        const Made made = good ? Made::Yes : found.errorCount() == errors ? Made::Perhaps : Made::No;
        if (const auto* const statement = std::get_if<ast::StatementPtr>(&item.what)) {
            foresee(callsIn(**statement), made, found);
            expected_.begun = expected_.begun || !isPlain(**statement);
        }
    }
    for (const ast::Item& item : file_->tree.items) expectWhatIsDefinedBy(item);
    return found;
}

void ScriptChecker::missWhatIsDefinedBy(const ast::Item& item) {
    incomplete_ = true;
    if (const std::string* const name = definedBy(item)) miss(*name);
}

/** Expects the definition in scripts that are checked later, because this one runs before them. */
void ScriptChecker::expectWhatIsDefinedBy(const ast::Item& item) {
    if (const std::string* const name = definedBy(item)) expected_.definitions.insert(*name);
}

bool ScriptChecker::gap() {
    ++gaps;
    incomplete_ = true;
    return true;
}

bool ScriptChecker::mayHave(const TaskContext* owner, const std::string& name, bool isFirst) {
    // Functions, programs and state machines belong to the component; functions may be global.
    const bool isOwn = owner == &component_ || !owner;
    if (isOwn && (missed_.count(name) || expected_.definitions.count(name) || expected_.components.count(name)))
        return gap();
    const bool isGlobal = isFirst || !owner;
    if (expected_.names || (isGlobal && expected_.globals) || expected_.more.count(owner)) return gap();
    return false;
}

bool ScriptChecker::isToCome(const std::string& peer) { return expected_.components.count(peer) && gap(); }

bool ScriptChecker::mayReplace(const std::string& function, bool isOfThis) {
    if (expected_.names || replaced_.count(function)) return gap();
    // A function that this script redefines keeps its operation.
    return !isOfThis && (bodies_.count(function) || expected_.definitions.count(function)) && gap();
}

bool ScriptChecker::isCertain(const diag::Diagnostic& error) const {
    if (error.severity != diag::Severity::Error) return true;
    if (expected_.names && isOneOf(kUnknownNames, error)) return false;
    if (expected_.types && isOneOf(kUnknownTypes, error)) return false;
    // A handle may belong to an operation that does not exist yet.
    return !(incomplete_ && error.code == "OPS148");
}

void ScriptChecker::keepWhatIsCertain(diag::Sink& found) {
    for (const diag::Diagnostic& each : sink_.all())
        if (isCertain(each)) found.add(each);
    sink_ = {};
}

CompileContext ScriptChecker::unevaluated(const Functions& functions) {
    CompileContext where = inEngine(functions);
    where.checkOnly = true;
    where.toCome = this;
    return where;
}

bool ScriptChecker::take(const ast::Item&, const ast::StatementPtr& statement) {
    const auto functions = definitions_.functions();
    return Compiler(unevaluated(*functions)).statement(*statement, file_->scope) != nullptr;
}

bool ScriptChecker::isFree(const char* kind, const char* code, const ast::Identifier& name) {
    if (expected_.names) return true;  // an earlier statement may have unloaded it
    if (!isNew(kind, code, name)) return false;
    const char* const other = kind == kProgram ? kMachine : kProgram;
    if (hasDefined(other, name.text)) {
        hasDefined(other, name.text, &refuse(kind, code, name, nameTaken(component_, other)));
        return false;
    }
    // The component may have run this script already.
    const auto scripting =
        boost::dynamic_pointer_cast<ScriptingService>(component_.provides()->getService("scripting"));
    const bool scripted = scripting && (scripting->hasProgram(name.text) || scripting->hasStateMachine(name.text));
    if (scripted || !component_.provides()->hasService(name.text)) return true;
    refuse(kind, code, name, nameTaken(component_, "service"));
    return false;
}

bool ScriptChecker::take(const ast::Item& item, const ast::Function& function) {
    if (!isNew("function", "OPS201", function.name)) return false;
    auto functions = definitions_.functions();
    auto definition = definitionOf(item, function, *functions);
    const CompileContext where = unevaluated(*functions);
    Service* const scripting = component_.provides()->getService("scripting").get();
    // An earlier statement may have removed the existing operation.
    if (!expected_.names && !hasFreeName(*definition, function.scope, scripting, where)) return false;
    const std::unique_ptr<Activation> pattern = Compiler(where).check(*definition);
    if (!pattern) return false;
    functions.reset();  // otherwise it would be copied
    addOperation(definition, *pattern);
    bodies_[function.name.text] = &function.body;
    definitions_.define(std::move(definition));
    return true;
}

void ScriptChecker::addOperation(const std::shared_ptr<const FunctionDefinition>& definition,
                                 const Activation& pattern) {
    const Service::shared_ptr scripting = component_.provides()->getService("scripting");
    Service* const home = homeOf(definition->tree->scope, scripting.get(), component_);
    if (!home) return miss(definition->name);
    if (home->getPart(definition->name)) return;  // from an earlier script, see mayReplace()
    home->add(definition->name, new UnexecutedPart(definition, pattern));
    operations_.emplace_back(home->provides(), definition->name);
}

bool ScriptChecker::take(const ast::Item& item, const ast::Program& program) {
    if (!isFree(kProgram, "OPS203", program.name)) return false;
    bodies_[program.name.text] = &program.body;
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

}  // namespace RTT::scripting::detail
