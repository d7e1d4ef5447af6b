// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/call_words.hpp>
#include <rtt/scripting/detail/compile/unit_compiler.hpp>

#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/internal/calls/standard_operations.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/types/GlobalsRepository.hpp>
#include <rtt/types/Types.hpp>

#include <diag/nearest_match.hpp>

#include <algorithm>
#include <optional>

namespace RTT::scripting::detail {

namespace {

void addNames(const ConfigurationInterface& values, std::vector<std::string>& names) {
    for (const auto& name : values.getAttributeNames()) names.push_back(name);
    for (const auto& name : values.properties()->list()) names.push_back(name);
}

bool isInstalledService(const std::string& name) {
    const std::vector<std::string> services = plugin::PluginLoader::Instance()->listServices();
    return std::find(services.begin(), services.end(), name) != services.end();
}

std::vector<std::string> unmistakableOperations() {
    std::vector<std::string> names;
    for (const internal::StandardOperation& each : internal::kStandardOperations)
        if (each.isUnmistakable) names.push_back(each.name);
    return names;
}

/** True if `name` is a misspelling of one of these names, and not one of them with something appended. */
bool isSlipOf(const std::string& name, const std::vector<std::string>& names) {
    const std::optional<std::string> meant = oroforge::diag::nearestMatch(name, names);
    return meant && name.size() <= meant->size() + 1 && meant->size() <= name.size() + 1;
}

}  // namespace

/** The names that are known after `last`. */
std::vector<std::string> UnknownName::knownNames(const Node& last, bool isLast, bool called) const {
    std::vector<std::string> known;
    const auto add = [&](const std::vector<std::string>& names) {
        known.insert(known.end(), names.begin(), names.end());
    };
    if (!isLast) {
        add(last.service->getProviderNames());
        if (last.component) add(last.component->getPeerList());
    }
    if (isLast || !called) add(last.service->getNames());
    const bool first = last.used == 0;
    if (first && isLast) {
        add(internal::GlobalService::Instance()->getNames());
        if (where_.component->provides()->hasService("scripting"))
            add(where_.component->provides()->getService("scripting")->getNames());
        for (const Functions* const functions : {where_.functions, where_.known})
            if (functions)
                for (const auto& function : *functions) known.push_back(function.first);
        if (called) add(types::Types()->getDottedTypes());
    }
    if (isLast && called) return known;
    addNames(*last.service, known);
    if (!first) return known;
    for (const Scope* scope = &unit_.names.scope(); scope; scope = scope->parent())
        for (const auto& entry : scope->entries()) known.push_back(entry.first);
    addNames(*types::GlobalsRepository::Instance(), known);
    known.insert(known.end(), {"true", "false"});
    return known;
}

/** For `x.operation()`, where x is a value. */
void UnknownName::checkCallOfValue(const NameCompiler::Nodes& nodes, const ast::Name& name) {
    Operand of;
    const Parts owner(name.parts.begin(), name.parts.end() - 1);
    if (owner.empty() || nodes.back().used >= owner.size()) return;
    const OperationInterfacePart* const operation = unit_.calls.callable(owner, owner.size(), nodes, false).part;
    const bool gives = operation && operation->arity() == 0;
    if (!unit_.names.value(nodes, owner, gives, of)) return;
    const ast::Identifier& last = name.parts.back();
    const std::string value = "'" + joined(owner) + "' is a value of type " + typeName(of);
    if (last.text == "collect" || last.text == "collectIfDone")
        reporter_.error(owner[0].at, "OPS147", "expected a SendHandle before '." + last.text + "', " + value);
    reporter_.error(last.at, "OPS134", value + " and has no operation '" + last.text + "'");
}

/** "component 'c' has no operation 'o'" */
std::string UnknownName::missing(const Node& last, const ast::Name& name) const {
    const bool isLast = last.used + 1 == name.parts.size();
    return (last.component ? "component '" + last.component->getName() + "'"
                           : "service '" + joined(name.parts, last.used) + "'") +
           (!isLast       ? " has no peer, service or value '"
            : name.called ? " has no operation '"
                          : " has no value or operation '") +
           name.parts[last.used].text + "'";
}

/** Warns that a name which may exist when the script runs may also be misspelt. */
void UnknownName::doubt(const Node& last, const ast::Name& name) const {
    const ast::Identifier& part = name.parts[last.used];
    const bool isLast = last.used + 1 == name.parts.size();
    const std::string meant = oroforge::diag::didYouMean(part.text, knownNames(last, isLast, name.called));
    if (!meant.empty())
        reporter_.warn(part.at, isLast && name.called ? "OPS134" : "OPS133",
                       missing(last, name) + " until now" + meant);
}

bool UnknownName::isToCome(const Node& last, const ast::Name& name) const {
    const Parts& parts = name.parts;
    const std::string& unknown = parts[std::min(last.used, parts.size() - 1)].text;
    const bool isOwn = parts.size() == 1 && name.called && last.component == where_.component;
    // A global operation with nearly the name of an existing one is unlikely.
    const bool mayBeGlobal = last.used == 0 && !(isOwn && isSlipOf(unknown, knownNames(last, true, true)));
    if (!where_.toCome->mayHave(last.service->getOwner(), unknown, mayBeGlobal)) return false;
    if (!where_.toCome->tellsDoubts() || last.used == parts.size()) return true;
    const bool isCall = last.component && name.called && last.used + 1 == parts.size();
    if (isCall && isSlipOf(unknown, unmistakableOperations())) return false;
    doubt(last, name);
    return true;
}

void UnknownName::fail(const NameCompiler::Nodes& nodes, const ast::Name& name) {
    const Parts& parts = name.parts;
    const Node& last = nodes.back();
    if (where_.toCome && isToCome(last, name)) throw Unresolved();
    if (name.called) checkCallOfValue(nodes, name);
    const bool unquoted = text_ == &name && !name.called;
    const std::string hint = unquoted ? "put texts into quotes: \"" + joined(parts) + '"' : "";
    if (last.used == parts.size())
        reporter_.error(parts[0].at, "OPS132",
                        "'" + joined(parts) + "' is a " + (last.component ? "component" : "service") +
                            ", expected a value or a call",
                        hint);
    const ast::Identifier& part = parts[last.used];
    const bool isLast = last.used + 1 == parts.size();
    const unsigned later = parts.size() == 1 ? lineOfLaterFunction(part) : 0;
    const bool canBeLoaded = !isLast && last.component && isInstalledService(part.text);
    reporter_.error(part.at, isLast && name.called ? "OPS134" : "OPS133",
                    missing(last, name) +
                        (later         ? " yet: the function is defined later, in line " + std::to_string(later)
                         : canBeLoaded ? "; loadService() loads a service of that name"
                                       : oroforge::diag::didYouMean(part.text, knownNames(last, isLast, name.called))),
                    hint);
}

/** The line where a function of that name is defined later, before which it cannot be called; 0 if there is none. */
unsigned UnknownName::lineOfLaterFunction(const ast::Identifier& name) const {
    const Scope* scope = &unit_.names.scope();
    while (scope && !scope->script()) scope = scope->parent();
    if (!scope) return 0;
    for (const ast::Item& item : scope->script()->items) {
        const auto* const function = std::get_if<ast::Function>(&item.what);
        if (function && function->name.text == name.text && function->name.at.line > name.at.line)
            return function->name.at.line;
    }
    return 0;
}

}  // namespace RTT::scripting::detail
