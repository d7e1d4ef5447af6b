// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A service of the name SERVICE_NAME.
#include <rtt/plugin/ServicePlugin.hpp>

namespace {

class NamedService : public RTT::Service {
public:
    explicit NamedService(RTT::TaskContext* owner) : RTT::Service(SERVICE_NAME, owner) {
        addOperation("owner", [owner] { return owner ? owner->getName() : std::string(); }).doc("Who has it.");
    }
};

}  // namespace

ORO_SERVICE_NAMED_PLUGIN(NamedService, SERVICE_NAME)
