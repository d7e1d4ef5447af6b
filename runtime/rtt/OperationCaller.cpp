// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/OperationCaller.hpp>

#include <rtt/OperationInterfacePart.hpp>
#include <rtt/Service.hpp>
#include <rtt/internal/calls/operation_part.hpp>

namespace RTT {

base::OperationCallerBaseInvoker::~OperationCallerBaseInvoker() = default;

namespace internal {

base::DisposableInterface::shared_ptr localOperation(OperationInterfacePart* part, const std::type_info& signature) {
    const auto* const local = dynamic_cast<const OperationPart*>(part);
    return local ? local->callerOf(signature) : part->getLocalOperation();
}

OperationInterfacePart* findOperation(const boost::shared_ptr<Service>& service, const std::string& name) {
    if (!service) return nullptr;
    OperationInterfacePart* const found = service->findOperation(name);
    return found ? found : service->getOperation(name);  // which warns
}

std::string operationName(OperationInterfacePart* part) { return part ? part->getName() : std::string(); }

void hold(base::OperationCallerInterface::shared_ptr& holder, base::OperationCallerInterface* held) {
    holder.reset(held);
}

}  // namespace internal
}  // namespace RTT
