// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/Service.hpp>

#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/OperationPart.hpp>

#include <algorithm>
#include <stdexcept>

namespace RTT {

void internal::throwNoObject() {
    throw std::runtime_error("the operation was called while there was no object for it");
}

Service::shared_ptr Service::Create(const std::string& name, TaskContext* owner) {
    shared_ptr made(new Service(name, owner));
    if (owner && owner->provides() != nullptr) owner->provides()->addService(made);
    return made;
}

namespace {

/** Null if it is none of this process. */
const internal::OperationPart* localOperation(const OperationInterfacePart* part) {
    return dynamic_cast<const internal::OperationPart*>(part);
}

}  // namespace

Service::Service(const std::string& name, TaskContext* owner) : DataFlowInterface(this), name_(name) {
    knowOwner(owner);
}

Service::~Service() { clear(); }

void Service::setOwner(TaskContext* owner) {
    // A component's own service becomes one of another component's: with the operations of the first one.
    if (owner && getOwner() && owner != owner_) (void)hasMember(name_);
    knowOwner(owner);
    for (const auto& entry : partsNow())
        if (const internal::OperationPart* const part = localOperation(entry.second.get()))
            part->caller()->setThread(part->caller()->getThread(), getOwnerExecutionEngine());
    for (auto& entry : services_) entry.second->setOwner(owner);
}

void Service::knowOwner(TaskContext* owner) {
    owner_ = owner;
    owner_gate_ = owner ? owner->engine()->gate() : nullptr;
}

bool Service::isCommon(const std::string& name) const { return TaskContext::isStandardOperation(name); }

void Service::addCommon() {
    TaskContext* const owner = getOwner();
    if (owner && owner->provides().get() == this) owner->addStandardOperations();
}

ExecutionEngine* Service::getOwnerExecutionEngine() const { return getOwner() ? owner_->engine() : nullptr; }

void Service::setParent(shared_ptr parent) {
    if (parent.get() != holder_) holder_ = nullptr;
    parent_ = parent;
}

Service::shared_ptr Service::getParent() const { return holder_ ? holder_->provides() : parent_.lock(); }

Service::shared_ptr Service::provides() {
    // In the constructor of a sub-class nobody owns this yet; the pointer then does not either.
    shared_ptr self = weak_from_this().lock();
    return self ? self : shared_ptr(this, [](Service*) {});
}

Service::shared_ptr Service::provides(const std::string& name) {
    if (shared_ptr found = getService(name)) return found;
    shared_ptr made = boost::make_shared<Service>(name);
    addService(made);
    return made;
}

Service::shared_ptr Service::getService(const std::string& name) {
    if (name == "this") return provides();
    const auto found = services_.find(name);
    return found == services_.end() ? nullptr : found->second;
}

bool Service::hasService(const std::string& name) const { return name == "this" || services_.count(name) != 0; }

Service::ProviderNames Service::getProviderNames() const {
    ProviderNames names;
    for (const auto& entry : services_) names.push_back(entry.first);
    return names;
}

bool Service::addService(shared_ptr service) {
    if (!service || service.get() == this) return false;
    const auto present = services_.find(service->getName());
    if (present != services_.end()) {
        if (present->second == service) return true;
        log(Error) << "service '" << service->getName() << "' was not added to '" << name_ << "': the name is in use"
                   << endlog();
        return false;
    }
    services_[service->getName()] = service;
    if (service->getOwner() != getOwner()) service->leaveComponent();
    service->setParent(provides());
    service->holder_ = this;
    service->setOwner(getOwner());
    return true;
}

void Service::removeService(const std::string& name) {
    const auto found = services_.find(name);
    if (found == services_.end()) return;
    const shared_ptr removed = found->second;  // may be held by others
    services_.erase(found);
    if (removed->holder_ && removed->holder_ != this) return;  // was added elsewhere since
    removed->leaveComponent();
    removed->setParent(nullptr);
    removed->setOwner(nullptr);
}

// Before the owner is another: writers of samples ask for it.
void Service::leaveComponent() {
    if (getOwner()) silencePorts();
    for (auto& entry : services_) entry.second->leaveComponent();
}

void Service::clear() {
    DataFlowInterface::clear();
    ConfigurationInterface::clear();
    OperationInterface::clear();
    owned_.clear();
    while (!services_.empty()) removeService(services_.begin()->first);
}

OperationInterfacePart* Service::getOperation(const std::string& name) {
    OperationInterfacePart* found = getPart(name);
    if (!found) log(Warning) << "service '" << name_ << "' has no operation '" << name << "'" << endlog();
    return found;
}

base::DisposableInterface::shared_ptr Service::getLocalOperation(const std::string& name) {
    OperationInterfacePart* found = getPart(name);
    return found ? found->getLocalOperation() : nullptr;
}

bool Service::setOperationThread(const std::string& name, ExecutionThread et) {
    const internal::OperationPart* const part = localOperation(getPart(name));
    if (!part) return false;
    part->caller()->setThread(et, part->caller()->getOwner());
    return true;
}

bool Service::resetOperation(const std::string& name, base::OperationBase* operation) {
    const internal::OperationPart* const part = localOperation(getPart(name));
    if (!part) {
        log(Error) << "operation '" << name << "' of '" << name_ << "' was not reset: there is no such operation"
                   << endlog();
        return false;
    }
    OperationInterfacePart* const reset = operation && operation->ready() ? part->reimplemented(*operation) : nullptr;
    if (!reset) {
        log(Error) << "operation '" << name << "' of '" << name_
                   << "' was not reset: the new one has no function, or one of another signature" << endlog();
        return false;
    }
    operation->setOwner(getOwnerExecutionEngine());
    OperationInterface::add(name, reset);
    return true;
}

void Service::removeOperation(const std::string& name) {
    const internal::OperationPart* const part = localOperation(getPart(name));
    const auto implementation = part ? part->caller() : nullptr;
    OperationInterface::remove(name);
    if (!implementation) return;
    owned_.erase(std::remove_if(owned_.begin(), owned_.end(),
                                [&](const auto& kept) { return kept->implementation() == implementation; }),
                 owned_.end());
}

void Service::adopt(base::OperationBase* operation, internal::CalleeBase* function, ExecutionThread et, bool callOnly) {
    owned_.emplace_back(operation);
    operation->setFunction(function, et, nullptr);
    registerOperation(*operation, callOnly);
}

bool Service::registerOperation(base::OperationBase& operation, bool callOnly) {
    const std::string& name = operation.getName();
    if (name.empty()) {
        log(Error) << "an operation was not added to '" << name_ << "': it has no name" << endlog();
        return false;
    }
    if (!operation.ready()) {
        log(Error) << "operation '" << name << "' was not added to '" << name_ << "': it has no function" << endlog();
        return false;
    }
    completeFor(name);
    const auto present = partsNow().find(name);
    const internal::OperationPart* const part =
        present == partsNow().end() ? nullptr : localOperation(present->second.get());
    if (present != partsNow().end() && (!part || part->caller() != operation.implementation())) {
        log(Warning) << "operation '" << name << "' of '" << name_ << "' replaces an earlier one of that name"
                     << endlog();
        removeOperation(name);
    }
    operation.setOwner(getOwnerExecutionEngine());
    OperationInterface::add(name, operation.makePart(callOnly));
    return true;
}

}  // namespace RTT
