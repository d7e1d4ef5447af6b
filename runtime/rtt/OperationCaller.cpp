// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/OperationCaller.hpp>

#include <rtt/Logger.hpp>
#include <rtt/OperationInterfacePart.hpp>
#include <rtt/Service.hpp>

#include <boost/core/demangle.hpp>

namespace RTT {

base::OperationCallerBaseInvoker::~OperationCallerBaseInvoker() = default;

namespace internal {

base::OperationCallerInterface::shared_ptr localOperation(OperationInterfacePart* part) {
    const base::OperationCallerInterface::shared_ptr local = part->getLocalOperation();
    if (!local)
        log(Error) << "operation '" << part->getName() << "' cannot be called from C++: it is remote" << endlog();
    return local;
}

OperationInterfacePart* findOperation(const boost::shared_ptr<Service>& service, const std::string& name) {
    return service ? service->getOperation(name) : nullptr;
}

std::string operationName(OperationInterfacePart* part) { return part ? part->getName() : std::string(); }

void hold(base::OperationCallerInterface::shared_ptr& holder, base::OperationCallerInterface* held) {
    holder.reset(held);
}

void logWrongSignature(const std::string& name, const char* wanted) {
    log(Error) << "operation '" << name << "' cannot be called as " << boost::core::demangle(wanted)
               << ": its result or arguments are of other types" << endlog();
}

}  // namespace internal
}  // namespace RTT
