// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/unit_compiler.hpp>

#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/types/GlobalsRepository.hpp>

namespace RTT::scripting::detail {

namespace {

// Limits of aliases in aliases: how deep, and how many in one use of an alias.
constexpr unsigned kDeepestAlias = 50, kMostAliases = 10000;

base::DataSourceBase::shared_ptr valueOf(const ConfigurationInterface& values, const std::string& name) {
    if (base::AttributeBase* const attribute = values.getValue(name)) return attribute->getDataSource();
    if (base::PropertyBase* const property = values.getProperty(name)) return property->getDataSource();
    return nullptr;
}

/** A global value, and how many parts name it: names of constants may have dots, such as those of messages. */
template <class Parts>
base::DataSourceBase::shared_ptr globalOf(const Parts& parts, std::size_t& used) {
    std::string name;
    base::DataSourceBase::shared_ptr found;
    for (std::size_t i = 0; i != parts.size(); ++i) {
        name += (i == 0 ? "" : ".") + parts[i].text;
        if (const auto source = valueOf(*types::GlobalsRepository::Instance(), name)) {
            found = source;
            used = i + 1;
        }
    }
    return found;
}

}  // namespace

NameCompiler::NameCompiler(UnitCompiler& unit) : UnitPart(unit), scope_(&unit.scope) {}

NameCompiler::Nodes NameCompiler::walk(const Parts& parts, std::size_t most) const {
    if (leadsToCome(parts)) throw Unresolved();
    TaskContext* component = where_.component;
    Nodes nodes{{component, component->provides(), 0}};
    for (std::size_t used = 0; used != most; ++used) {
        const std::string& part = parts[used].text;
        Node next{nullptr, nullptr, used + 1};
        const Node& here = nodes.back();
        const auto toComponent = [&](TaskContext* to) { next = {to, to->provides(), used + 1}; };
        if (used == 0 && (part == "this" || part == "task")) {
            toComponent(component);
        } else if (used == 0 && where_.service && where_.service->hasService(part)) {
            next.service = where_.service->getService(part);
        } else if (here.component && here.component->hasPeer(part)) {
            toComponent(here.component->getPeer(part));
        } else if (here.service->hasService(part)) {
            next.service = here.service->getService(part);
        } else if (used == 0 && part == component->getName()) {
            toComponent(component);
        } else if (used == 0 && internal::GlobalService::Instance()->hasService(part)) {
            next.service = internal::GlobalService::Instance()->getService(part);
        } else if (here.component && (part == "states" || part == "programs")) {
            reporter_.warn(parts[used].at, "OPS130",
                           "'" + part + "' is not needed here; programs and state machines are services");
            next.component = here.component;
            next.service = here.service;
        }
        if (!next.service) break;
        nodes.push_back(next);
    }
    return nodes;
}

bool NameCompiler::value(const Nodes& nodes, const Parts& parts, bool mayCall, Operand& found) {
    return variable(parts, found) || valueIn(nodes, parts, found) || (mayCall && resultOf(nodes, parts, found));
}

Operand NameCompiler::compile(const ast::Name& name, ast::Place at) {
    Operand result;
    if (!name.called && variable(name.parts, result)) return result;
    if (unit_.sends.handleCall(name, at, result)) return result;
    const auto nodes = walk(name.parts, name.parts.size());
    if (!name.called && valueIn(nodes, name.parts, result)) return result;
    if (unit_.calls.call(name, nodes, at, result)) return result;
    if (name.called ? unit_.calls.construct(name, at, result) : resultOf(nodes, name.parts, result)) return result;
    unit_.unknownName.fail(nodes, name);
}

const Scope::Entry* NameCompiler::declared(const std::string& name) const {
    const Scope::Entry* const alias = reporter_.alias().declared;
    return scope_->find(name, alias ? alias->declared : Scope::kEver);
}

/** The value of an alias, with the names that were known where it was declared. */
Operand NameCompiler::valueOfAlias(const Scope::Entry& alias, const ast::Identifier& name) {
    struct Elsewhere {
        explicit Elsewhere(NameCompiler& of) : names(of), scope(of.scope_), use(of.reporter_.alias()) {
            ++names.aliases_;
        }
        ~Elsewhere() {
            --names.aliases_;
            names.scope_ = scope;
            names.reporter_.setAlias(use);
        }
        NameCompiler& names;
        const Scope* const scope;
        const Reporter::Alias use;
    } elsewhere(*this);
    const bool isOutermost = !elsewhere.use.declared;
    const ast::Identifier* const used = isOutermost ? &name : elsewhere.use.used;
    if (isOutermost) alias_uses_ = 0;
    // Each use is compiled separately, so the code of aliases that use others twice grows exponentially.
    if (++alias_uses_ > kMostAliases || aliases_ > kDeepestAlias) {
        reporter_.setAlias({});
        reporter_.error(used->at, "OPS131",
                        "alias '" + used->text + "' is made of more than " +
                            (aliases_ > kDeepestAlias ? std::to_string(kDeepestAlias) + " others in each other"
                                                      : std::to_string(kMostAliases) + " others") +
                            "; assign one of them to a variable, and use that");
    }
    scope_ = alias.scope;
    reporter_.setAlias({&alias, used});
    return unit_.expressions.compile(*alias.alias);
}

/** True if the name is also that of a peer or service, and what follows is not a member of the variable. */
bool NameCompiler::isElsewhere(const Parts& parts, const Operand& variable) const {
    return parts.size() > 1 && (leadsToCome(parts) || walk(parts, 1).size() > 1) &&
           (!variable.source || !variable.source->getMember(parts[1].text));
}

/** True if the path leads through a component that does not exist yet and will replace what has its name now. */
bool NameCompiler::leadsToCome(const Parts& parts) const {
    if (!where_.toCome) return false;
    std::size_t first = 0;
    while (first != parts.size() && (parts[first].text == "this" || parts[first].text == "task" ||
                                     parts[first].text == where_.component->getName()))
        ++first;
    if (first + 1 >= parts.size()) return false;
    if (first == 0 && where_.service && where_.service->hasService(parts[0].text)) return false;
    return where_.toCome->isToCome(parts[first].text);
}

bool NameCompiler::variable(const Parts& parts, Operand& found) {
    const Scope::Entry* const entry = declared(parts[0].text);
    if (!entry) return false;
    if (entry->handle) {
        if (parts.size() != 1) return false;
        const Source handle = entry->handle->source();
        if (!handle) unit_.sends.failUnsent(parts[0]);
        found = values_.fromSource(handle, parts[0].at);
        return true;
    }
    if (entry->alias) {
        found = valueOfAlias(*entry, parts[0]);
    } else {
        found = values_.fromSource(entry->source, parts[0].at);
        found.constant = entry->constant && found.address;
    }
    found.at = parts[0].at;
    if (isElsewhere(parts, found)) return false;
    found = members(found, parts, 1);
    return true;
}

bool NameCompiler::valueIn(const Nodes& nodes, const Parts& parts, Operand& found) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
        if (node->used == parts.size()) continue;
        Source source;
        std::size_t used = node->used + 1;
        if (node->used == 0 && where_.service) source = valueOf(*where_.service, parts[0].text);
        if (!source) {
            source = valueOf(*node->service, parts[node->used].text);
            const TaskContext* const owner = node->service->getOwner();
            if (source && where_.peers && owner && owner != where_.component) where_.peers->add(*owner);
        }
        if (!source && node->used == 0) source = globalOf(parts, used);
        if (!source) continue;
        found = members(values_.fromSource(source, parts[0].at), parts, used);
        return true;
    }
    return false;
}

/** The result of an operation or function called without parentheses, or a member of it: `port.last.x`. */
bool NameCompiler::resultOf(const Nodes& nodes, const Parts& parts, Operand& found) {
    for (std::size_t count = parts.size(); count != 0; --count) {
        const Callable called = unit_.calls.callable(parts, count, nodes, false);
        if (!called.function && !called.part) continue;
        ast::Name name;
        name.parts.assign(parts.begin(), parts.begin() + static_cast<Parts::difference_type>(count));
        const ast::Place at = parts[0].at;
        found = unit_.calls.call(called, name, at);
        found = members(found, parts, count);
        return true;
    }
    return false;
}

Operand NameCompiler::members(Operand of, const Parts& parts, std::size_t from) {
    for (std::size_t i = from; i != parts.size(); ++i) of = unit_.expressions.member(of, parts[i]);
    return of;
}

}  // namespace RTT::scripting::detail
