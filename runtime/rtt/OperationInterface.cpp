// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/OperationInterface.hpp>

#include <rtt/FactoryExceptions.hpp>
#include <rtt/Handle.hpp>
#include <rtt/Logger.hpp>
#include <rtt/internal/DataSource.hpp>
#include <rtt/internal/OperationCallerC.hpp>

#include <mutex>

namespace RTT {

OperationInterfacePart::~OperationInterfacePart() = default;

base::DisposableInterface::shared_ptr OperationInterfacePart::getLocalOperation() const { return nullptr; }

Handle OperationInterfacePart::produceSignal(base::ActionInterface*, const Args&, ExecutionEngine*) const {
    throw no_asynchronous_operation_exception("operation '" + getName() + "' is no signal");
}

OperationInterfacePart::shared_constptr OperationInterfacePart::hold(const OperationInterfacePart* part) {
    if (!part) return nullptr;
    shared_constptr held = part->weak_from_this().lock();
    return held ? held : shared_constptr(part, [](const OperationInterfacePart*) {});
}

OperationInterface::OperationInterface() = default;
OperationInterface::~OperationInterface() = default;

std::vector<std::string> OperationInterface::getNames() const {
    std::vector<std::string> names;
    for (const auto& entry : parts()) names.push_back(entry.first);
    return names;
}

bool OperationInterface::hasMember(const std::string& name) const { return parts().count(name) != 0; }

OperationInterfacePart* OperationInterface::getPart(const std::string& name) const {
    const auto found = parts().find(name);
    return found == parts_.end() ? nullptr : found->second.get();
}

OperationInterfacePart& OperationInterface::part(const std::string& name) const {
    OperationInterfacePart* found = getPart(name);
    if (!found) throw name_not_found_exception(name);
    return *found;
}

internal::OperationCallerC OperationInterface::create(const std::string& name, ExecutionEngine* caller) const {
    const OperationInterfacePart* const found = getPart(name);
    if (!found) log(Warning) << "there is no operation '" << name << "' to create a caller of" << endlog();
    return internal::OperationCallerC(found, name, caller);
}

base::DataSourceBase::shared_ptr OperationInterface::produce(const std::string& name, const Args& args,
                                                             ExecutionEngine* caller) const {
    return part(name).produce(args, caller);
}
base::DataSourceBase::shared_ptr OperationInterface::produceSend(const std::string& name, const Args& args,
                                                                 ExecutionEngine* caller) const {
    return part(name).produceSend(args, caller);
}
base::DataSourceBase::shared_ptr OperationInterface::produceHandle(const std::string& name) const {
    return part(name).produceHandle();
}
base::DataSourceBase::shared_ptr OperationInterface::produceCollect(
    const std::string& name, const Args& args, internal::DataSource<bool>::shared_ptr blocking) const {
    return part(name).produceCollect(args, blocking);
}
Handle OperationInterface::produceSignal(const std::string& name, base::ActionInterface* action, const Args& args,
                                         ExecutionEngine* subscriber) const {
    return part(name).produceSignal(action, args, subscriber);
}
OperationInterface::Descriptions OperationInterface::getArgumentList(const std::string& name) const {
    return part(name).getArgumentList();
}
std::string OperationInterface::getResultType(const std::string& name) const { return part(name).resultType(); }
std::string OperationInterface::getDescription(const std::string& name) const { return part(name).description(); }
int OperationInterface::getArity(const std::string& name) const { return static_cast<int>(part(name).arity()); }
int OperationInterface::getCollectArity(const std::string& name) const {
    return static_cast<int>(part(name).collectArity());
}
const types::TypeInfo* OperationInterface::getCollectType(const std::string& name, int index) const {
    return part(name).getCollectType(static_cast<unsigned>(index));
}
bool OperationInterface::isSynchronous(const std::string& name) const { return part(name).isSynchronous(); }

void OperationInterface::add(const std::string& name, OperationInterfacePart* part) {
    completeFor(name);
    parts_[name].reset(part);
}

void OperationInterface::remove(const std::string& name) {
    completeFor(name);
    parts_.erase(name);
}

void OperationInterface::clear() {
    common_ = Common::None;
    parts_.clear();
}

bool OperationInterface::isCommon(const std::string&) const { return false; }
void OperationInterface::addCommon() {}

const OperationInterface::Parts& OperationInterface::parts() const {
    // For callers, the operations that this adds have always existed.
    if (common_.load(std::memory_order_acquire) != Common::None) const_cast<OperationInterface*>(this)->complete();
    return parts_;
}

void OperationInterface::completeFor(const std::string& added) {
    if (common_ == Common::Later && isCommon(added)) complete();
}

void OperationInterface::complete() {
    static std::recursive_mutex completing;  // of all services, because each is completed only once
    const std::lock_guard<std::recursive_mutex> lock(completing);
    if (common_ != Common::Later) return;
    common_ = Common::Now;
    try {
        addCommon();
    } catch (...) {
        common_ = Common::Later;  // the next access tries again
        throw;
    }
    common_.store(Common::None, std::memory_order_release);
}

}  // namespace RTT
