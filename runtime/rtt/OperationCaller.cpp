// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/OperationCaller.hpp>

#include <rtt/OperationInterfacePart.hpp>
#include <rtt/Service.hpp>

namespace RTT {

base::OperationCallerBaseInvoker::~OperationCallerBaseInvoker() = default;

namespace internal {

base::DisposableInterface::shared_ptr localOperation(OperationInterfacePart* part) { return part->getLocalOperation(); }

OperationInterfacePart* findOperation(const boost::shared_ptr<Service>& service, const std::string& name) {
    return service ? service->getOperation(name) : nullptr;
}

std::string operationName(OperationInterfacePart* part) { return part ? part->getName() : std::string(); }

void hold(base::OperationCallerInterface::shared_ptr& holder, base::OperationCallerInterface* held) {
    holder.reset(held);
}

}  // namespace internal
}  // namespace RTT
