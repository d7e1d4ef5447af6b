// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <check/check.hpp>

#include <model/interfaces.hpp>

namespace oroforge::check {

namespace {

void checkPolicy(const model::Port& port, diag::Sink& sink) {
    const model::Policy& policy = *port.policy;
    if (port.direction == model::Direction::Out) {
        sink.error(policy.where, "OM053",
                   "port '" + port.name.value + "' is an output; a policy belongs to the input port");
    }
    if (policy.type == "data" && policy.size) {
        sink.error(policy.size->where, "OM052",
                   "a 'data' connection has no size; expected type 'buffer' or 'circular_buffer'");
    }
    if (policy.type == "data") return;
    if (!policy.size) {
        sink.error(policy.where, "OM051", "a '" + policy.type + "' connection needs the attribute 'size', in samples");
    } else if (policy.size->value < 1 || policy.size->value > 1e9) {
        sink.error(policy.size->where, "OM051",
                   "size '" + policy.size->text + "' is not a number of samples from 1 to 1000000000");
    }
}

}  // namespace

void ports(const model::Package& package, diag::Sink& sink) {
    model::eachInterface(package, [&](const model::Interface& interface, const model::ServicePath&) {
        for (const auto& port : interface.ports) {
            if (port.event && port.direction == model::Direction::Out) {
                sink.error(port.eventWhere, "OM050",
                           "port '" + port.name.value + "' is an output; only an input can be an event port");
            }
            if (port.policy) checkPolicy(port, sink);
        }
    });
}

}  // namespace oroforge::check
