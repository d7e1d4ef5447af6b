// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Builds transitions that wait for a call of an operation or for new data on a port.
#include <rtt/scripting/detail/machine/machine_builder.hpp>

#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <diag/nearest_match.hpp>

namespace RTT::scripting::detail {

namespace {

std::string pathOf(const std::vector<ast::Identifier>& parts) {
    std::string path;
    for (const ast::Identifier& part : parts) path += (path.empty() ? "" : ".") + part.text;
    return path;
}

std::string counted(std::size_t number, const std::string& of) {
    return std::to_string(number) + " " + of + (number == 1 ? "" : "s");
}

/** The signal of an operation; null if it has none. */
std::shared_ptr<internal::SignalBase> signalOf(const OperationInterfacePart& operation) {
    const auto local = operation.getLocalOperation();
    const auto* const caller = dynamic_cast<const base::OperationCallerInterface*>(local.get());
    return caller && caller->callee() ? caller->callee()->signal() : nullptr;
}

}  // namespace

/** What the path before the name of an operation or port leads to. */
MachineBuilder::Source MachineBuilder::sourceOf(const ast::Transition& tree) {
    Source here{where_.component, where_.component->provides()};
    const std::size_t own = tree.event[0].text == "this" || tree.event[0].text == "task" ||
                            tree.event[0].text == where_.component->getName();
    if (where_.toCome && own + 1 < tree.event.size() && !model_->service->hasService(tree.event[0].text) &&
        where_.toCome->isToCome(tree.event[own].text))
        return {};
    for (std::size_t i = 0; i + 1 != tree.event.size(); ++i) {
        const std::string& part = tree.event[i].text;
        Source next;
        if (i == 0 && part != "this" && model_->service->hasService(part)) {
            next.service = model_->service->getService(part);
        } else if (here.component && here.component->hasPeer(part)) {
            next.component = here.component->getPeer(part);
            next.service = next.component->provides();
        } else if (i == 0 && (part == "this" || part == "task" || part == where_.component->getName())) {
            next = here;
        } else if (here.service->hasService(part)) {
            next.service = here.service->getService(part);
        } else if (i == 0 && internal::GlobalService::Instance()->hasService(part)) {
            next.service = internal::GlobalService::Instance()->getService(part);
        } else {
            if (where_.toCome && where_.toCome->mayHave(here.service->getOwner(), part, i == 0)) return {};
            std::vector<std::string> names = here.service->getProviderNames();
            if (here.component)
                for (const std::string& peer : here.component->getPeerList()) names.push_back(peer);
            error(tree.event[i].at, "OPS311",
                  "'" + here.service->getName() + "' has no peer or service '" + part + "'" +
                      oroforge::diag::didYouMean(part, names));
            return {};
        }
        here = next;
    }
    return here;
}

void MachineBuilder::unknownEvent(const ast::Transition& tree, const Source& source) {
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
ActionPtr MachineBuilder::assignment(const ast::Expression& to, const base::DataSourceBase::shared_ptr& from,
                                     const Scope& scope) {
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

GuardPtr MachineBuilder::portGuard(const ast::Transition& tree, base::InputPortInterface& port, const Scope& scope) {
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

void MachineBuilder::refuseOperation(const ast::Transition& tree) {
    where_.sink
        ->error(at(tree.event.back().at), "OPS313",
                "calls of operation '" + pathOf(tree.event) + "' cannot be listened to")
        .hint("its component has to add it with addEventOperation()");
}

void MachineBuilder::addOperationEvent(const ast::Transition& tree, OperationInterfacePart& operation,
                                       const Scope& scope, const MachineState* state) {
    const ast::Identifier& name = tree.event.back();
    std::shared_ptr<internal::SignalBase> signal = signalOf(operation);
    if (!signal) return refuseOperation(tree);
    if (operation.arity() != tree.arguments.size()) {
        error(name.at, "OPS314",
              "operation '" + pathOf(tree.event) + "' has " + counted(operation.arity(), "argument") + ", found " +
                  counted(tree.arguments.size(), "variable") + (operation.arity() == 1 ? " for it" : " for them"));
        return;
    }
    std::vector<base::DataSourceBase::shared_ptr> arguments;
    std::vector<ActionPtr> assign;
    for (unsigned i = 0; i != operation.arity(); ++i) {
        const types::TypeInfo* const type = operation.getArgumentType(i + 1);
        arguments.push_back(type ? type->buildValue() : nullptr);
        if (!arguments.back()) {
            error(tree.arguments[i]->at, "OPS317",
                  "the type of argument " + std::to_string(i + 1) + " of operation '" + pathOf(tree.event) +
                      "' is not known");
            return;
        }
        assign.push_back(assignment(*tree.arguments[i], arguments.back(), scope));
        if (!assign.back()) return;
    }
    auto event = std::make_unique<OperationEvent>(std::move(arguments), std::move(assign));
    event->transition = transition(tree, scope);
    event->state = state;
    listening_.push_back({event.get(), std::move(signal)});
    model_->events.push_back(std::move(event));
}

}  // namespace RTT::scripting::detail
