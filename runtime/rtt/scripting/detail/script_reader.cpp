// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/script_reader.hpp>

#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/scripting/detail/parser.hpp>

#include <utility>

namespace RTT {
namespace scripting {
namespace detail {

ScriptReader::ScriptReader(TaskContext& component, std::shared_ptr<SourceFile> file)
    : component_(component), file_(std::move(file)), compiler_(surroundings(internal::GlobalEngine::Instance())) {}

ScriptReader::~ScriptReader() = default;

bool ScriptReader::take(const ast::Item& item) {
    return std::visit([&](const auto& what) { return take(item, what); }, item.what);
}

bool ScriptReader::parse() {
    file_->tree = detail::parse(file_->text, file_->name, sink_);
    return !sink_.hadErrors();
}

bool ScriptReader::isNew(const char* kind, const char* code, const ast::Identifier& name) {
    const auto added = defined_.emplace(std::string(kind) + ' ' + name.text, name.at);
    if (added.second) return true;
    error(name.at, code, std::string(kind) + " '" + name.text + "' is defined twice in this script")
        .note(at(added.first->second), "first defined here");
    return false;
}

std::shared_ptr<const FunctionDefinition> ScriptReader::definitionOf(const ast::Function& function) const {
    auto made = std::make_shared<FunctionDefinition>();
    made->name = function.name.text;
    made->tree = partOf(file_, function);
    made->scope = partOf(file_, file_->scope);
    made->file = file_->name;
    return made;
}

std::shared_ptr<const MachineType> ScriptReader::typeOf(const ast::Item& item, const ast::StateMachine& type) const {
    auto made = std::make_shared<MachineType>();
    made->tree = partOf(file_, type);
    made->file = file_;
    made->text = file_->textOf(item);
    made->at = item.at;
    return made;
}

Surroundings ScriptReader::surroundings(ExecutionEngine* caller) {
    Surroundings where;
    where.component = &component_;
    where.caller = caller;
    where.file = file_->name;
    where.sink = &sink_;
    return where;
}

Surroundings ScriptReader::inEngine(const Functions& functions) {
    Surroundings where = surroundings(component_.engine());
    where.functions = &functions;
    return where;
}

oroforge::diag::Diagnostic& ScriptReader::error(ast::Place place, const char* code, const std::string& message) {
    return sink_.error(at(place), code, message);
}

}  // namespace detail
}  // namespace scripting
}  // namespace RTT
