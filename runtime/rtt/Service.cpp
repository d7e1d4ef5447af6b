// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/Service.hpp>

#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/calls/operation_part.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>

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

/** Null if it belongs to another process. */
const internal::OperationPart* localOperation(const OperationInterfacePart* part) {
    return dynamic_cast<const internal::OperationPart*>(part);
}
internal::OperationPart* localPart(OperationInterfacePart* part) {
    return dynamic_cast<internal::OperationPart*>(part);
}

}  // namespace

Service::Service(const std::string& name, TaskContext* owner) : DataFlowInterface(this), name_(name) {
    knowOwner(owner);
}

Service::~Service() { clear(); }

void Service::setOwner(TaskContext* owner) {
    // A component's own service moves to another component with the operations of the first one.
    if (owner && getOwner() && owner != owner_) (void)hasMember(name_);
    knowOwner(owner);
    for (const Parts* const parts : {&partsNow(), &std::as_const(local_)})
        for (const auto& entry : *parts)
            if (const internal::OperationPart* const part = localOperation(entry.second.get()))
                part->setThread(part->caller()->getThread(), getOwnerExecutionEngine());
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
    // In the constructor of a subclass no pointer owns this yet, so this one does not either.
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
    const shared_ptr removed = found->second;  // others may hold it
    services_.erase(found);
    if (removed->holder_ && removed->holder_ != this) return;  // was added elsewhere meanwhile
    removed->leaveComponent();
    removed->setParent(nullptr);
    removed->setOwner(nullptr);
}

// Call it before the owner changes, because writers of samples use the owner.
void Service::leaveComponent() {
    if (getOwner()) silencePorts();
    for (auto& entry : services_) entry.second->leaveComponent();
}

void Service::clear() {
    DataFlowInterface::clear();
    ConfigurationInterface::clear();
    OperationInterface::clear();
    owned_.clear();
    local_.clear();
    while (!services_.empty()) removeService(services_.begin()->first);
}

OperationInterfacePart* Service::getOperation(const std::string& name) {
    OperationInterfacePart* found = getPart(name);
    if (!found) log(Warning) << "service '" << name_ << "' has no operation '" << name << "'" << endlog();
    return found;
}

base::DisposableInterface::shared_ptr Service::getLocalOperation(const std::string& name) {
    const OperationInterfacePart* const found = findOperation(name);
    if (const internal::OperationPart* const part = localOperation(found)) return part->firstCaller();
    return found ? found->getLocalOperation() : nullptr;
}

OperationInterfacePart* Service::findOperation(const std::string& name) const {
    const auto local = local_.find(name);
    return local == local_.end() ? getPart(name) : local->second.get();
}

bool Service::hasOperation(const std::string& name) const { return findOperation(name) != nullptr; }

std::vector<std::string> Service::getOperationNames() const {
    std::vector<std::string> names = getNames();
    for (const auto& entry : local_) names.push_back(entry.first);
    std::sort(names.begin(), names.end());
    return names;
}

bool Service::setOperationThread(const std::string& name, ExecutionThread et) {
    const internal::OperationPart* const part = localOperation(findOperation(name));
    if (part) part->setThread(et, part->caller()->getOwner());
    return part != nullptr;
}

bool Service::resetOperation(const std::string& name, base::OperationBase* operation) {
    const internal::OperationPart* const part = localOperation(findOperation(name));
    if (!part) {
        log(Error) << "operation '" << name << "' of '" << name_ << "' was not reset: there is no such operation"
                   << endlog();
        return false;
    }
    OperationInterfacePart* const reset =
        operation && operation->hasFunction() ? part->reimplemented(*operation) : nullptr;
    if (!reset) {
        log(Error) << "operation '" << name << "' of '" << name_
                   << "' was not reset: the new one has no function, or one of another signature" << endlog();
        return false;
    }
    operation->setOwner(getOwnerExecutionEngine());
    const auto local = local_.find(name);
    if (local == local_.end())
        OperationInterface::add(name, reset);
    else
        local->second.reset(reset);
    return true;
}

void Service::removeOperation(const std::string& name) {
    const internal::OperationPart* const part = localOperation(findOperation(name));
    const auto implementation = part ? part->caller() : nullptr;
    OperationInterface::remove(name);
    local_.erase(name);
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

bool Service::accepts(const base::OperationBase& operation) const {
    const std::string& name = operation.getName();
    if (name.empty())
        log(Error) << "an operation was not added to '" << name_ << "': it has no name" << endlog();
    else if (!operation.hasFunction())
        log(Error) << "operation '" << name << "' was not added to '" << name_ << "': it has no function" << endlog();
    else
        return true;
    return false;
}

void Service::replaceEarlier(const base::OperationBase& operation) {
    const std::string name = operation.getName();
    completeFor(name);
    const auto present = partsNow().find(name);
    const auto local = local_.find(name);
    const OperationInterfacePart* const earlier = local != local_.end()         ? local->second.get()
                                                  : present != partsNow().end() ? present->second.get()
                                                                                : nullptr;
    if (!earlier) return;
    const internal::OperationPart* const part = localOperation(earlier);
    if (!part || part->caller() != operation.implementation())
        log(Warning) << "operation '" << name << "' of '" << name_ << "' replaces an earlier one of that name"
                     << endlog();
    else if (local == local_.end())
        return;
    removeOperation(name);
}

bool Service::registerOperation(base::OperationBase& operation, bool callOnly) {
    if (!accepts(operation)) return false;
    replaceEarlier(operation);
    operation.setOwner(getOwnerExecutionEngine());
    OperationInterface::add(operation.getName(), operation.makePart(callOnly));
    return true;
}

bool Service::addLocalOperation(base::OperationBase& operation) {
    if (!accepts(operation)) return false;
    const internal::OperationPart* const present = localOperation(findOperation(operation.getName()));
    if (present && present->caller() == operation.implementation()) return true;
    replaceEarlier(operation);
    operation.setOwner(getOwnerExecutionEngine());
    local_[operation.getName()].reset(operation.makePart(false));
    return true;
}

void Service::registerLate(base::OperationBase* late, internal::CalleeBase* function, base::OperationBase& operation,
                           const std::type_info& signature) {
    owned_.emplace_back(late);
    const boost::intrusive_ptr<internal::CalleeBase> held(function);
    if (!accepts(operation)) return owned_.pop_back();
    operation.setOwner(getOwnerExecutionEngine());
    late->shareDescription(operation);
    late->setFunction(function, operation.implementation()->getThread(), nullptr);
    registerOperation(*late, false);
    localPart(getPart(late->getName()))->overload(signature, operation.implementation());
}

bool Service::overload(const std::string& name, const std::type_info& signature, base::OperationCallerInterface* made,
                       internal::CalleeBase* function) {
    const base::OperationCallerInterface::shared_ptr owned(made);
    made->setCallee(function);
    internal::OperationPart* const part = localPart(getPart(name));
    if (part && owned->ready()) part->overload(signature, owned);
    return part && owned->ready();
}

}  // namespace RTT
