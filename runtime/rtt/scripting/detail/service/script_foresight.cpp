// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The effects of calls in a script that is checked.
#include <rtt/scripting/detail/service/script_checker.hpp>

#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/scripting/detail/syntax/script_text.hpp>

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <type_traits>
#include <utility>

namespace RTT::scripting::detail {

namespace diag = oroforge::diag;

namespace {

// A limit, for scripts that run each other again and again.
constexpr unsigned kMostFollowed = 500;

bool isOneOf(const std::string& word, std::initializer_list<const char*> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

/** The literals among the arguments. */
std::vector<const std::string*> textsOf(const ast::Expressions& arguments) {
    std::vector<const std::string*> texts;
    for (const ast::ExpressionPtr& argument : arguments) {
        const auto* const literal = std::get_if<ast::Literal>(&argument->what);
        texts.push_back(literal ? std::get_if<std::string>(&literal->value) : nullptr);
    }
    return texts;
}

std::optional<double> numberOf(const ast::Expression& expression) {
    if (const auto* const unary = std::get_if<ast::Unary>(&expression.what)) {
        const std::optional<double> value = unary->op == '-' ? numberOf(*unary->operand) : std::nullopt;
        return value ? std::optional<double>(-*value) : std::nullopt;
    }
    const auto* const literal = std::get_if<ast::Literal>(&expression.what);
    if (!literal) return std::nullopt;
    return std::visit(
        [](const auto& value) -> std::optional<double> {
            typedef std::decay_t<decltype(value)> T;
            if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool> && !std::is_same_v<T, char>)
                return static_cast<double>(value);
            else
                return std::nullopt;
        },
        literal->value);
}

ForeseenArgument argumentOf(const ast::Expression& expression) {
    ForeseenArgument result;
    result.number = numberOf(expression);
    const auto* const name = std::get_if<ast::Name>(&expression.what);
    if (!name || name->parts.size() != 1) return result;
    if (!name->called) {
        result.name = name->parts.front().text;
    } else if (name->parts.front().text == "strings") {
        std::vector<std::string> list;
        for (const std::string* const text : textsOf(name->arguments)) {
            if (!text) return result;
            list.push_back(*text);
        }
        result.list = std::move(list);
    }
    return result;
}

/** The operation at the path; null if there is none. `known` is false if the path leads to something that does not
    exist. */
OperationInterfacePart* operationAt(TaskContext& component, const std::vector<ast::Identifier>& path, bool& known) {
    TaskContext* task = &component;
    Service::shared_ptr service = component.provides();
    for (std::size_t i = 0; i + 1 != path.size(); ++i) {
        const std::string& part = path[i].text;
        if (i == 0 && isOneOf(part, {"this", "task"})) continue;
        if (task && task->hasPeer(part)) {
            task = task->getPeer(part);
            service = task->provides();
        } else if (service->hasService(part)) {
            service = service->getService(part);
            task = nullptr;
        } else {
            known = false;
            return nullptr;
        }
    }
    known = true;
    const std::string& name = path.back().text;
    OperationInterfacePart* const part = service->getPart(name);
    return part || path.size() != 1 ? part : internal::GlobalService::Instance()->getPart(name);
}

}  // namespace

/** False for values, which are names without an argument list. */
bool ScriptChecker::isCallOfOperation(const FoundCall& call) const {
    const auto& path = call.name->parts;
    // It is a variable, or a handle of an earlier call.
    if (file_->scope.find(path.front().text)) return false;
    if (path.size() > 1 && isOneOf(path.back().text, {"collect", "collectIfDone"})) return false;
    if (call.name->called) return true;
    if (path.size() == 1 && bodies_.count(path.front().text)) return true;
    bool known = false;
    if (operationAt(component_, path, known)) return true;
    // For an arm that does not exist yet, `arm.configure` is a statement, but `arm.speed` would not be one.
    return !known && call.ignored;
}

void ScriptChecker::foresee(const std::vector<FoundCall>& calls, Made made, diag::Sink& found) {
    for (FoundCall call : calls) {
        // The effects of a statement with an error are unknown, so only its declarations are expected.
        if (made == Made::No && !isOwnOperation(*call.name)) continue;
        call.certain = call.certain && made == Made::Yes;
        if (isCallOfOperation(call)) foresee(call, found);
    }
}

/** True if it names an existing operation or function without a path. */
bool ScriptChecker::isOwnOperation(const ast::Name& name) const {
    bool known = false;
    return name.parts.size() == 1 &&
           (bodies_.count(name.parts.front().text) || operationAt(component_, name.parts, known));
}

void ScriptChecker::foresee(const FoundCall& call, diag::Sink& found) {
    std::vector<ast::Identifier> path = call.name->parts;
    bool certain = call.certain;
    if (path.size() > 1 && isOneOf(path.back().text, {"call", "send", "cmd"})) {
        certain = false;
        path.pop_back();
    }
    const auto body = bodies_.find(path.front().text);
    const bool isOwn = body != bodies_.end() && (path.size() == 1 || component_.provides()->hasService(body->first));
    if (isOwn) {
        if (!entered_.insert(body->second).second) return;
        foresee(callsIn(*body->second), Made::Yes, found);
        entered_.erase(body->second);
        return;
    }
    ForeseenCall foreseen;
    for (const ast::Identifier& part : path) foreseen.path.push_back(part.text);
    foreseen.texts = textsOf(call.name->arguments);
    for (const ast::ExpressionPtr& argument : call.name->arguments) foreseen.others.push_back(argumentOf(*argument));
    foreseen.certain = certain && certain_;
    foreseen.ignored = call.ignored;
    foreseen.script = file_->name;
    foreseen.line = call.at.line;
    const CallProblem problem = forecast_.foresee(foreseen, expected_);
    if (!problem.script.empty()) follow(problem.script, certain, found);
    if (problem.text.empty()) return;
    const ast::Place place =
        problem.argument < call.name->arguments.size() ? call.name->arguments[problem.argument]->at : call.at;
    if (problem.isWarning)
        found.warning(at(place), problem.code, problem.text);
    else
        found.error(at(place), problem.code, problem.text);
}

/** Checks a script that this one runs; its definitions then exist. */
void ScriptChecker::follow(const std::string& script, bool certain, diag::Sink& found) {
    ScriptChecker* first = this;
    while (first->outer_) first = first->outer_;
    diag::Sink unread;
    const auto text = readScript(script, unread);
    if (!text || isWithin(script) || first->followed_ == kMostFollowed) return expected_.anything();
    ++first->followed_;
    const auto file = std::make_shared<SourceFile>(script, *text, file_);
    ScriptChecker inner(*this, file, certain);
    const diag::Sink inside = inner.check();
    for (const diag::Diagnostic& each : inside.all()) found.add(each);
    for (const ast::Item& item : file->tree.items)
        if (const auto* const function = std::get_if<ast::Function>(&item.what)) replaced_.insert(function->name.text);
    replaced_.insert(inner.replaced_.begin(), inner.replaced_.end());
}

/** True for this script and for those around it. */
bool ScriptChecker::isWithin(const std::string& script) const {
    std::error_code unknown;
    for (const ScriptChecker* each = this; each; each = each->outer_)
        if (each->file_->name.str() == script || std::filesystem::equivalent(each->file_->name.str(), script, unknown))
            return true;
    return false;
}

}  // namespace RTT::scripting::detail
