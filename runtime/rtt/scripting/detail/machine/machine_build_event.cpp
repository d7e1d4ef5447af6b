// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/machine/machine_build_event.hpp>

#include <rtt/TaskContext.hpp>
#include <rtt/scripting/detail/compile/call_words.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <diag/nearest_match.hpp>

namespace RTT::scripting::detail {

namespace {

std::string amount(std::size_t number, const std::string& of) {
    return std::to_string(number) + " " + of + (number == 1 ? "" : "s");
}

/** The signal of an operation; null if it has none. */
std::shared_ptr<internal::SignalBase> signalOf(const OperationInterfacePart& operation) {
    const auto local = operation.getLocalOperation();
    const auto* const caller = dynamic_cast<const base::OperationCallerInterface*>(local.get());
    return caller && caller->callee() ? caller->callee()->signal() : nullptr;
}

}  // namespace

void EventBuilder::add(const ast::Transition& tree, const Scope& scope, std::vector<MachineTransition>& to,
                       const MachineState* state) {
    if (tree.event.empty()) {
        to.push_back(transitions_.build(tree, scope));
        return;
    }
    const internal::NamedObject source = sourceOf(tree);
    if (!source.service) return;
    const std::string& name = tree.event.back().text;
    if (auto* const port = source.service->getPortType<base::InputPortInterface>(name)) {
        MachineTransition made = transitions_.build(tree, scope);
        made.event = portGuard(tree, *port, scope);
        to.push_back(std::move(made));
    } else if (OperationInterfacePart* const operation = source.service->getPart(name)) {
        addOperationEvent(tree, *operation, scope, state);
    } else {
        unknownEvent(tree, source);
    }
}

/** What the path before the name of an operation or port leads to. */
internal::NamedObject EventBuilder::sourceOf(const ast::Transition& tree) const {
    internal::NamedObject here{where_.component, where_.component->provides(), {}};
    const std::size_t own = tree.event[0].text == "this" || tree.event[0].text == "task" ||
                            tree.event[0].text == where_.component->getName();
    if (where_.toCome && own + 1 < tree.event.size() && !model_.service->hasService(tree.event[0].text) &&
        where_.toCome->isToCome(tree.event[own].text))
        return {};
    for (std::size_t i = 0; i + 1 != tree.event.size(); ++i) {
        const std::string& part = tree.event[i].text;
        internal::NamedObject next;
        if (i == 0 && part != "this" && part != "task") next.service = model_.service->getService(part);
        if (!next.service) next = i == 0 ? internal::firstOf(*where_.component, part) : internal::childOf(here, part);
        if (!next.service) {
            if (where_.toCome && where_.toCome->mayHave(here.service->getOwner(), part, i == 0)) return {};
            std::vector<std::string> names = here.service->getProviderNames();
            if (here.component)
                for (const std::string& peer : here.component->getPeerList()) names.push_back(peer);
            error(tree.event[i].at, "OPS311",
                  "'" + here.service->getName() + "' has no peer or service '" + part + "'" +
                      oroforge::diag::didYouMean(part, names));
            return {};
        }
        here = std::move(next);
    }
    return here;
}

void EventBuilder::unknownEvent(const ast::Transition& tree, const internal::NamedObject& source) const {
    const ast::Identifier& name = tree.event.back();
    if (where_.toCome && where_.toCome->mayHave(source.service->getOwner(), name.text, false)) return;
    std::vector<std::string> names = source.service->getNames();
    bool isOutput = false;
    for (base::PortInterface* port : source.service->getPorts()) {
        if (port->asInput())
            names.push_back(port->getName());
        else
            isOutput = isOutput || port->getName() == name.text;
    }
    error(name.at, "OPS312",
          "'" + source.service->getName() + "' has no operation or input port '" + name.text + "'" +
              (isOutput ? "; it is an output port" : oroforge::diag::didYouMean(name.text, names)));
}

/** Assigns an argument to a variable. If `to` is not a variable or its type does not fit, reports an error and returns
    null. */
ActionPtr EventBuilder::assignment(const ast::Expression& to, const base::DataSourceBase::shared_ptr& from,
                                   const Scope& scope) const {
    const std::size_t errors = where_.sink->errorCount();
    const unsigned gaps = where_.toCome ? where_.toCome->gaps : 0;
    const base::DataSourceBase::shared_ptr variable = Compiler(where_).variable(to, scope);
    if (!variable || !variable->isAssignable()) {
        if (where_.sink->errorCount() == errors && (!where_.toCome || where_.toCome->gaps == gaps))
            error(to.at, "OPS314", "expected a variable of type " + from->getTypeName() + ", found something else");
    } else if (!variable->hasTypeOf(*from)) {
        error(to.at, "OPS314",
              "expected a variable of type " + from->getTypeName() + ", found one of type " + variable->getTypeName());
    } else {
        return ActionPtr(variable->updateAction(from.get()));
    }
    return nullptr;
}

GuardPtr EventBuilder::portGuard(const ast::Transition& tree, base::InputPortInterface& port, const Scope& scope) {
    const ast::Identifier& name = tree.event.back();
    std::shared_ptr<PortReader>& reader = readers_[&port];
    if (!reader) {
        const types::TypeInfo* const type = port.getTypeInfo();
        const base::DataSourceBase::shared_ptr sample = type ? type->buildValue() : nullptr;
        if (!sample) {
            error(name.at, "OPS317", "the type of port '" + name.text + "' is not known, so that it cannot be read");
            return nullptr;
        }
        reader = std::make_shared<PortReader>(port, sample);
    }
    if (tree.arguments.size() > 1) {
        error(
            tree.arguments[1]->at, "OPS314",
            "port '" + name.text + "' gives one value, found " + std::to_string(tree.arguments.size()) + " variables");
        return nullptr;
    }
    ActionPtr assign;
    if (!tree.arguments.empty()) {
        assign = assignment(*tree.arguments.front(), reader->sample(), scope);
        if (!assign) return nullptr;
    }
    return std::make_unique<PortGuard>(reader, std::move(assign), at(name.at));
}

void EventBuilder::refuseOperation(const ast::Transition& tree) const {
    where_.sink
        ->error(at(tree.event.back().at), "OPS313",
                "calls of operation '" + joined(tree.event) + "' cannot be listened to")
        .hint("its component has to add it with addEventOperation()");
}

void EventBuilder::addOperationEvent(const ast::Transition& tree, OperationInterfacePart& operation, const Scope& scope,
                                     const MachineState* state) {
    const ast::Identifier& name = tree.event.back();
    std::shared_ptr<internal::SignalBase> signal = signalOf(operation);
    if (!signal) return refuseOperation(tree);
    if (operation.arity() != tree.arguments.size()) {
        error(name.at, "OPS314",
              "operation '" + joined(tree.event) + "' has " + amount(operation.arity(), "argument") + ", found " +
                  amount(tree.arguments.size(), "variable") + (operation.arity() == 1 ? " for it" : " for them"));
        return;
    }
    std::vector<base::DataSourceBase::shared_ptr> arguments;
    std::vector<ActionPtr> assign;
    for (unsigned i = 0; i != operation.arity(); ++i) {
        const types::TypeInfo* const type = operation.getArgumentType(i + 1);
        arguments.push_back(type ? type->buildValue() : nullptr);
        if (!arguments.back()) {
            error(tree.arguments[i]->at, "OPS317",
                  "the type of argument " + std::to_string(i + 1) + " of operation '" + joined(tree.event) +
                      "' is not known");
            return;
        }
        assign.push_back(assignment(*tree.arguments[i], arguments.back(), scope));
        if (!assign.back()) return;
    }
    auto event = std::make_unique<OperationEvent>(std::move(arguments), std::move(assign));
    event->transition = transitions_.build(tree, scope);
    event->state = state;
    listening_.push_back({event.get(), std::move(signal)});
    model_.events.push_back(std::move(event));
}

void EventBuilder::listen(const std::shared_ptr<EventQueue>& queue) const {
    for (const Listening& each : listening_) each.event->listenTo(*each.signal, queue);
}

}  // namespace RTT::scripting::detail
