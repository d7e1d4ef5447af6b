// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Resolves a dotted name: a variable of the script, a value in a component or service, or a call without parentheses.
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

// Limits of aliases in aliases: how deep, and how many in one use of an alias.
constexpr unsigned kDeepestAlias = 50, kMostAliases = 10000;

base::DataSourceBase::shared_ptr valueIn(const ConfigurationInterface& values, const std::string& name) {
    if (base::AttributeBase* const attribute = values.getValue(name)) return attribute->getDataSource();
    if (base::PropertyBase* const property = values.getProperty(name)) return property->getDataSource();
    return nullptr;
}

void addNames(const ConfigurationInterface& values, std::vector<std::string>& names) {
    for (const auto& name : values.getAttributeNames()) names.push_back(name);
    for (const auto& name : values.properties()->list()) names.push_back(name);
}

bool isInstalledService(const std::string& name) {
    const std::vector<std::string> services = plugin::PluginLoader::Instance()->listServices();
    return std::find(services.begin(), services.end(), name) != services.end();
}

std::string text(const std::vector<ast::Identifier>& parts, std::size_t count) {
    std::string joined;
    for (std::size_t i = 0; i != count; ++i) joined += (i ? "." : "") + parts[i].text;
    return joined;
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

/** The component itself, then the targets of the parts of the path, at most `most`. */
std::vector<UnitCompiler::Node> UnitCompiler::walk(const Parts& parts, std::size_t most) const {
    if (leadsToCome(parts)) throw Unresolved();
    TaskContext* component = where_.component;
    std::vector<Node> nodes{{component, component->provides(), 0}};
    for (std::size_t used = 0; used != most; ++used) {
        const std::string& part = parts[used].text;
        Node next{nullptr, nullptr, used + 1};
        const Node& here = nodes.back();
        if (used == 0 && (part == "this" || part == "task")) {
            next.component = component;
            next.service = component->provides();
        } else if (used == 0 && where_.service && where_.service->hasService(part)) {
            next.service = where_.service->getService(part);
        } else if (here.component && here.component->hasPeer(part)) {
            next.component = here.component->getPeer(part);
            next.service = next.component->provides();
        } else if (here.service->hasService(part)) {
            next.service = here.service->getService(part);
        } else if (used == 0 && part == component->getName()) {
            next.component = component;
            next.service = component->provides();
        } else if (used == 0 && internal::GlobalService::Instance()->hasService(part)) {
            next.service = internal::GlobalService::Instance()->getService(part);
        } else if (here.component && (part == "states" || part == "programs")) {
            warn(parts[used].at, "OPS130",
                 "'" + part + "' is not needed here; programs and state machines are services");
            next.component = here.component;
            next.service = here.service;
        }
        if (!next.service) break;
        nodes.push_back(next);
    }
    return nodes;
}

Operand UnitCompiler::name(const ast::Name& name, ast::Place at) {
    Operand result;
    if (!name.called && variableNamed(name.parts, result)) return result;
    if (handleCall(name, at, result)) return result;
    const auto nodes = walk(name.parts, name.parts.size());
    if (!name.called && valueNamed(nodes, name.parts, result)) return result;
    if (call(name, nodes, at, result)) return result;
    if (name.called ? construct(name, at, result) : resultNamed(nodes, name.parts, result)) return result;
    unknownName(nodes, name);
}

const Scope::Entry* UnitCompiler::declared(const std::string& name) const {
    return scope_->find(name, alias_ ? alias_->declared : Scope::kEver);
}

/** The value of an alias, with the names that were known where it was declared. */
Operand UnitCompiler::valueOfAlias(const Scope::Entry& alias, const ast::Identifier& name) {
    struct Elsewhere {
        explicit Elsewhere(UnitCompiler& of) : unit(of), scope(of.scope_), entry(of.alias_) { ++unit.aliases_; }
        ~Elsewhere() {
            --unit.aliases_;
            unit.scope_ = scope;
            unit.alias_ = entry;
        }
        UnitCompiler& unit;
        Scope* const scope;
        const Scope::Entry* const entry;
    } elsewhere(*this);
    if (!alias_) {
        used_alias_ = &name;
        alias_uses_ = 0;
    }
    // Each use is compiled separately, so the code of aliases that use others twice grows exponentially.
    if (++alias_uses_ > kMostAliases || aliases_ > kDeepestAlias) {
        alias_ = nullptr;
        error(used_alias_->at, "OPS131",
              "alias '" + used_alias_->text + "' is made of more than " +
                  (aliases_ > kDeepestAlias ? std::to_string(kDeepestAlias) + " others in each other"
                                            : std::to_string(kMostAliases) + " others") +
                  "; assign one of them to a variable, and use that");
    }
    scope_ = const_cast<Scope*>(alias.scope);  // expressions declare nothing
    alias_ = &alias;
    return expression(*alias.alias);
}

/** True if the name is also that of a peer or service, and what follows is not a member of the variable. */
bool UnitCompiler::isElsewhere(const Parts& parts, const Operand& variable) const {
    return parts.size() > 1 && (leadsToCome(parts) || walk(parts, 1).size() > 1) &&
           (!variable.source || !variable.source->getMember(parts[1].text));
}

/** True if the path leads through a component that does not exist yet and will replace what has its name now. */
bool UnitCompiler::leadsToCome(const Parts& parts) const {
    if (!where_.toCome) return false;
    std::size_t first = 0;
    while (first != parts.size() && (parts[first].text == "this" || parts[first].text == "task" ||
                                     parts[first].text == where_.component->getName()))
        ++first;
    if (first + 1 >= parts.size()) return false;
    if (first == 0 && where_.service && where_.service->hasService(parts[0].text)) return false;
    return where_.toCome->isToCome(parts[first].text);
}

bool UnitCompiler::variableNamed(const Parts& parts, Operand& found) {
    const Scope::Entry* const entry = declared(parts[0].text);
    if (!entry) return false;
    if (entry->handle) {
        if (parts.size() != 1) return false;
        const Source handle = entry->handle->source();
        if (!handle) failUnsent(parts[0]);
        found = fromSource(handle, parts[0].at);
        return true;
    }
    if (entry->alias) {
        found = valueOfAlias(*entry, parts[0]);
    } else {
        found = fromSource(entry->source, parts[0].at);
        found.constant = entry->constant && found.address;
    }
    found.at = parts[0].at;
    if (isElsewhere(parts, found)) return false;
    found = members(found, parts, 1);
    return true;
}

bool UnitCompiler::valueNamed(const std::vector<Node>& nodes, const Parts& parts, Operand& found) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
        if (node->used == parts.size()) continue;
        Source source;
        if (node->used == 0 && where_.service) source = valueIn(*where_.service, parts[0].text);
        if (!source) {
            source = valueIn(*node->service, parts[node->used].text);
            const TaskContext* const owner = node->service->getOwner();
            if (source && where_.peers && owner && owner != where_.component) where_.peers->add(*owner);
        }
        if (!source && node->used == 0) source = valueIn(*types::GlobalsRepository::Instance(), parts[0].text);
        if (!source) continue;
        found = members(fromSource(source, parts[0].at), parts, node->used + 1);
        return true;
    }
    return false;
}

/** The result of an operation or function called without parentheses, or a member of it: `port.last.x`. */
bool UnitCompiler::resultNamed(const std::vector<Node>& nodes, const Parts& parts, Operand& found) {
    for (std::size_t count = parts.size(); count != 0; --count) {
        const Callable called = callable(parts, count, nodes, false);
        if (!called.function && !called.part) continue;
        ast::Name name;
        name.parts.assign(parts.begin(), parts.begin() + static_cast<Parts::difference_type>(count));
        const ast::Place at = parts[0].at;
        found = called.function ? callFunction(called.function, name, at) : callOperation(called, name, at);
        found = members(found, parts, count);
        return true;
    }
    return false;
}

Operand UnitCompiler::members(Operand of, const Parts& parts, std::size_t from) {
    for (std::size_t i = from; i != parts.size(); ++i) of = member(of, parts[i]);
    return of;
}

/** The names that are known after `last`. */
std::vector<std::string> UnitCompiler::knownNames(const Node& last, bool isLast, bool called) const {
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
    for (const Scope* scope = scope_; scope; scope = scope->parent())
        for (const auto& entry : scope->entries()) known.push_back(entry.first);
    addNames(*types::GlobalsRepository::Instance(), known);
    known.insert(known.end(), {"true", "false"});
    return known;
}

/** For `x.operation()`, where x is a value. */
void UnitCompiler::checkCallOfValue(const std::vector<Node>& nodes, const ast::Name& name) {
    Operand of;
    const Parts owner(name.parts.begin(), name.parts.end() - 1);
    if (owner.empty() || nodes.back().used >= owner.size()) return;
    const OperationInterfacePart* const operation = callable(owner, owner.size(), nodes, false).part;
    const bool gives = operation && operation->arity() == 0;
    if (!variableNamed(owner, of) && !valueNamed(nodes, owner, of) && !(gives && resultNamed(nodes, owner, of))) return;
    const ast::Identifier& last = name.parts.back();
    const std::string value = "'" + text(owner, owner.size()) + "' is a value of type " + typeName(of);
    if (last.text == "collect" || last.text == "collectIfDone")
        error(owner[0].at, "OPS147", "expected a SendHandle before '." + last.text + "', " + value);
    error(last.at, "OPS134", value + " and has no operation '" + last.text + "'");
}

/** "component 'c' has no operation 'o'" */
std::string UnitCompiler::missing(const Node& last, const ast::Name& name) const {
    const bool isLast = last.used + 1 == name.parts.size();
    return (last.component ? "component '" + last.component->getName() + "'"
                           : "service '" + text(name.parts, last.used) + "'") +
           (!isLast       ? " has no peer, service or value '"
            : name.called ? " has no operation '"
                          : " has no value or operation '") +
           name.parts[last.used].text + "'";
}

/** Warns that a name which may exist when the script runs may also be misspelt. */
void UnitCompiler::doubt(const Node& last, const ast::Name& name) const {
    const ast::Identifier& part = name.parts[last.used];
    const bool isLast = last.used + 1 == name.parts.size();
    const std::string meant = oroforge::diag::didYouMean(part.text, knownNames(last, isLast, name.called));
    if (!meant.empty())
        warn(part.at, isLast && name.called ? "OPS134" : "OPS133", missing(last, name) + " until now" + meant);
}

bool UnitCompiler::isToCome(const Node& last, const ast::Name& name) const {
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

void UnitCompiler::unknownName(const std::vector<Node>& nodes, const ast::Name& name) {
    const Parts& parts = name.parts;
    const Node& last = nodes.back();
    if (where_.toCome && isToCome(last, name)) throw Unresolved();
    if (name.called) checkCallOfValue(nodes, name);
    const bool unquoted = text_ == &name && !name.called;
    const std::string hint = unquoted ? "put texts into quotes: \"" + text(parts, parts.size()) + '"' : "";
    if (last.used == parts.size())
        error(parts[0].at, "OPS132",
              "'" + text(parts, parts.size()) + "' is a " + (last.component ? "component" : "service") +
                  ", expected a value or a call",
              hint);
    const ast::Identifier& part = parts[last.used];
    const bool isLast = last.used + 1 == parts.size();
    const unsigned later = parts.size() == 1 ? lineOfLaterFunction(part) : 0;
    const bool canBeLoaded = !isLast && last.component && isInstalledService(part.text);
    error(part.at, isLast && name.called ? "OPS134" : "OPS133",
          missing(last, name) + (later ? " yet: the function is defined later, in line " + std::to_string(later)
                                 : canBeLoaded
                                     ? "; loadService() loads a service of that name"
                                     : oroforge::diag::didYouMean(part.text, knownNames(last, isLast, name.called))),
          hint);
}

/** The line where a function of that name is defined later, before which it cannot be called; 0 if there is none. */
unsigned UnitCompiler::lineOfLaterFunction(const ast::Identifier& name) const {
    const Scope* scope = scope_;
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
