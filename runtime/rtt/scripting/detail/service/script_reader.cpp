// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/service/script_reader.hpp>

#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/engine/interruption.hpp>
#include <rtt/scripting/detail/syntax/parser.hpp>
#include <rtt/scripting/detail/execute/process.hpp>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <thread>
#include <utility>

namespace RTT::scripting::detail {

namespace diag = oroforge::diag;
using internal::Interruption;

namespace {

constexpr unsigned kMostYields = 10000;
// After so many yields of a statement, each further one waits a little.
constexpr unsigned kEagerYields = 100;
constexpr std::chrono::microseconds kPause(100);

bool hasAlias(const Scope* scope) {
    for (; scope; scope = scope->parent())
        for (const auto& named : scope->entries())
            if (named.second.alias) return true;
    return false;
}

bool isOfName(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/** The functions that a function may call, which are those that its text names. With all functions, a script that is
    run repeatedly would make each function keep all of its predecessors. */
std::shared_ptr<const Functions> callableIn(const std::string& text, const Scope& scope, const Functions& known) {
    if (hasAlias(&scope))
        return std::make_shared<Functions>(known);  // an alias may call functions that the text does not name
    auto callable = std::make_shared<Functions>();
    for (auto at = text.begin(); at != text.end();) {
        const auto begin = std::find_if(at, text.end(), isOfName);
        at = std::find_if_not(begin, text.end(), isOfName);
        const auto named = known.find(std::string(begin, at));
        if (named != known.end()) callable->insert(*named);
    }
    return callable;
}

}  // namespace

std::string nameTaken(const TaskContext& component, const char* kind) {
    return "component '" + component.getName() + "' has a " + kind + " of that name already";
}

ScriptReader::ScriptReader(TaskContext& component, std::shared_ptr<SourceFile> file)
    : component_(component), file_(std::move(file)), compiler_(atTopLevel()) {}

ScriptReader::~ScriptReader() = default;

bool ScriptReader::take(const ast::Item& item) {
    return std::visit([&](const auto& what) { return take(item, what); }, item.what);
}

bool ScriptReader::parse() {
    file_->tree = detail::parse(file_->text, file_->name, sink_);
    return !sink_.hadErrors();
}

bool ScriptReader::execute(const Code& code) {
    Process process(code);
    Interruption* const interruption = Interruption::ofThisThread();
    const Interruption::Region region(interruption, Interruption::Region::Script);
    const Interruption::Listener listener([&process] { process.pause(); });
    // A user who can interrupt the script may wait without limit.
    const bool patient = interruption && interruption->isPatient();
    unsigned counted = 0;
    for (unsigned yields = 0; patient || counted <= kMostYields; yields += yields != kEagerYields) {
        if (interruption && interruption->asked()) {
            error(process.started() ? process.place() : code.placeOf(code.begin()), "", "interrupted");
            return false;
        }
        const Process::Outcome outcome = process.run();
        if (outcome == Process::Outcome::Finished) return true;
        if (outcome == Process::Outcome::Failed) {
            process.report(sink_, file_->name, "");
            return false;
        }
        counted += !process.idles();
        if (yields == kEagerYields) std::this_thread::sleep_for(kPause);
    }
    error(process.place(), "OPS410",
          "the statement yielded " + std::to_string(kMostYields) +
              " times and did not end; what has to wait longer belongs into a program");
    return false;
}

bool ScriptReader::isNew(const char* kind, const char* code, const ast::Identifier& name) {
    if (defined_.emplace(std::string(kind) + ' ' + name.text, name.at).second) return true;
    hasDefined(kind, name.text,
               &error(name.at, code, std::string(kind) + " '" + name.text + "' is defined twice in this script"));
    return false;
}

bool ScriptReader::hasDefined(const char* kind, const std::string& name, diag::Diagnostic* error) const {
    const auto found = defined_.find(std::string(kind) + ' ' + name);
    if (found != defined_.end() && error) error->note(at(found->second), "first defined here");
    return found != defined_.end();
}

std::shared_ptr<const FunctionDefinition> ScriptReader::definitionOf(const ast::Item& item,
                                                                     const ast::Function& function,
                                                                     const Functions& known) const {
    auto made = std::make_shared<FunctionDefinition>();
    made->name = function.name.text;
    made->tree = partOf(file_, function);
    made->scope = partOf(file_, file_->scope);
    made->file = file_->name;
    made->text = partOf(file_, file_->text);
    made->functions = callableIn(file_->textOf(item), file_->scope, known);
    return made;
}

std::shared_ptr<const MachineType> ScriptReader::typeOf(const ast::Item& item, const ast::StateMachine& type) const {
    auto made = std::make_shared<MachineType>();
    made->tree = partOf(file_, type);
    made->file = file_;
    const SourceFile::Excerpt excerpt = file_->withComment(item);
    made->text = excerpt.letters;
    made->at = excerpt.at;
    return made;
}

CompileContext ScriptReader::context(ExecutionEngine* caller) {
    CompileContext where;
    where.component = &component_;
    where.caller = caller;
    where.file = file_->name;
    where.text = partOf(file_, file_->text);
    where.sink = &sink_;
    return where;
}

CompileContext ScriptReader::atTopLevel() {
    CompileContext where = context(internal::GlobalEngine::Instance());
    where.sent = sent_;
    return where;
}

CompileContext ScriptReader::inEngine(const Functions& functions) {
    CompileContext where = context(component_.engine());
    where.functions = &functions;
    return where;
}

oroforge::diag::Diagnostic& ScriptReader::error(ast::Place place, const char* code, const std::string& message) {
    return sink_.error(at(place), code, message);
}

diag::Diagnostic& ScriptReader::refuse(const char* kind, const char* code, const ast::Identifier& name,
                                       const std::string& why) {
    return error(name.at, code, std::string(kind) + " '" + name.text + "' cannot be loaded: " + why);
}

}  // namespace RTT::scripting::detail
