// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Connects an operation that a component requires to one that another component provides.
#include "failure.hpp"
#include "lookup.hpp"
#include "wiring.hpp"

#include <rtt/ServiceRequester.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/dotted_name.hpp>

#include <tuple>

namespace OCL::deploy {

namespace {

/** `component[.service…].operation` */
struct OperationPath {
    std::string component, services, operation;

    explicit OperationPath(const std::string& path) : component(path.substr(0, path.find('.'))) {
        if (component.size() == path.size()) return;
        std::tie(services, operation) = RTT::internal::splitAtLastDot(path.substr(component.size() + 1));
    }
};

bool refuse(const std::string& why) { return failed("could not connect operations: " + why); }

/** The caller at the path, without creating requesters; null, with the reason, if there is none. */
RTT::base::OperationCallerBaseInvoker* findCaller(RTT::TaskContext& component, const OperationPath& path,
                                                  std::string& error) {
    RTT::ServiceRequester::shared_ptr requester = component.requires_();
    for (const std::string& name : RTT::internal::partsOf(path.services)) {
        if (!requester->requiresService(name)) {
            error = "component '" + path.component + "' requires no service '" + name + "'";
            return nullptr;
        }
        requester = requester->requires_(name);
    }
    RTT::base::OperationCallerBaseInvoker* const caller = requester->getOperationCaller(path.operation);
    if (!caller)
        error = "component '" + path.component + "' requires no operation '" + path.operation + "'" +
                (path.services.empty() ? "" : " of service '" + path.services + "'");
    return caller;
}

}  // namespace

bool Wiring::connectOperations(const std::string& requested, const std::string& provided) {
    const OperationPath from(requested), to(provided);
    RTT::TaskContext* const client = findComponent(session_, from.component, "connect operations");
    RTT::TaskContext* const server = findComponent(session_, to.component, "connect operations");
    if (!client || !server) return false;
    std::string error;
    RTT::base::OperationCallerBaseInvoker* const caller = findCaller(*client, from, error);
    if (!caller) return refuse(error);
    if (caller->ready()) return refuse("'" + requested + "' is connected already");
    const RTT::Service::shared_ptr service = findService(*server, to.services, error);
    if (!service) return refuse(error);
    if (!service->hasOperation(to.operation))
        return refuse("component '" + to.component + "' provides no operation '" + to.operation + "'" +
                      (to.services.empty() ? "" : " in service '" + to.services + "'"));
    return doneOr("could not connect '" + requested + "' to '" + provided + "'", [&] {
        return caller->setImplementationPart(service->findOperation(to.operation), client->engine());
    });
}

}  // namespace OCL::deploy
