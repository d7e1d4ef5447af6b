// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/ServiceRequester.hpp>

#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>

#include <algorithm>

namespace RTT {

ServiceRequester::shared_ptr ServiceRequester::Create(const std::string& name, TaskContext* owner) {
    return shared_ptr(new ServiceRequester(name, owner));
}

ServiceRequester::ServiceRequester(const std::string& name, TaskContext* owner) : name_(name), owner_(owner) {}
ServiceRequester::~ServiceRequester() = default;

bool ServiceRequester::addOperationCaller(base::OperationCallerBaseInvoker& caller) {
    if (!callers_.emplace(caller.getName(), &caller).second) {
        log(Error) << "requester '" << name_ << "' has a caller of operation '" << caller.getName() << "' already"
                   << endlog();
        return false;
    }
    if (owner_) caller.setCaller(owner_->engine());
    return true;
}

ServiceRequester::OperationCallerNames ServiceRequester::getOperationCallerNames() const {
    OperationCallerNames names;
    for (const auto& entry : callers_) names.push_back(entry.first);
    return names;
}

base::OperationCallerBaseInvoker* ServiceRequester::getOperationCaller(const std::string& name) const {
    const auto found = callers_.find(name);
    return found == callers_.end() ? nullptr : found->second;
}

void ServiceRequester::setOwner(TaskContext* owner) {
    owner_ = owner;
    // Without an owner do not touch the callers: they were members of a component under destruction and are gone.
    if (owner)
        for (auto& entry : callers_) entry.second->setCaller(owner->engine());
    for (auto& entry : requesters_) entry.second->setOwner(owner);
}

ServiceRequester::shared_ptr ServiceRequester::requires_() {
    shared_ptr self = weak_from_this().lock();
    return self ? self : shared_ptr(this, [](ServiceRequester*) {});
}

ServiceRequester::shared_ptr ServiceRequester::requires_(const std::string& name) {
    if (name == "this") return requires_();
    shared_ptr& requester = requesters_[name];
    if (!requester) requester = Create(name, owner_);
    return requester;
}

bool ServiceRequester::addServiceRequester(shared_ptr requester) {
    if (!requester) return false;
    if (!requesters_.emplace(requester->getRequestName(), requester).second) {
        log(Error) << "requester '" << requester->getRequestName() << "' was not added to '" << name_
                   << "': the name is in use" << endlog();
        return false;
    }
    requester->setOwner(owner_);
    return true;
}

bool ServiceRequester::requiresService(const std::string& name) const { return requesters_.count(name) != 0; }

ServiceRequester::RequesterNames ServiceRequester::getRequesterNames() const {
    RequesterNames names;
    for (const auto& entry : requesters_) names.push_back(entry.first);
    return names;
}

bool ServiceRequester::connectTo(Service::shared_ptr service) {
    if (!service) return false;
    service_ = service;
    for (auto& entry : callers_) {
        if (entry.second->ready() || !service->hasOperation(entry.first)) continue;
        entry.second->setImplementationPart(service->findOperation(entry.first), owner_ ? owner_->engine() : nullptr);
    }
    const std::string missing = missingOperations();
    if (missing.empty())
        log(Info) << "service '" << service->getName() << "' offers all operations that '" << name_ << "' requires"
                  << endlog();
    else
        log(Info) << "service '" << service->getName() << "' does not offer what '" << name_
                  << "' requires: " << missing << endlog();
    return missing.empty();
}

std::string ServiceRequester::missingOperations() const {
    std::string names;
    for (const auto& entry : callers_)
        if (!entry.second->ready()) names += (names.empty() ? "" : ", ") + entry.first;
    return names;
}

bool ServiceRequester::ready() const {
    return std::all_of(callers_.begin(), callers_.end(), [](const auto& entry) { return entry.second->ready(); });
}

void ServiceRequester::disconnect() {
    for (auto& entry : callers_) entry.second->disconnect();
    for (auto& entry : requesters_) entry.second->disconnect();
    service_.reset();
}

void ServiceRequester::clear() {
    callers_.clear();
    requesters_.clear();
    service_.reset();
}

}  // namespace RTT
