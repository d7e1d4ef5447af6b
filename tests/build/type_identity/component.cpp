// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component with the shared type: it links no typekit.
#include "shared_type.hpp"

#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/Property.hpp>
#include <rtt/TaskContext.hpp>

namespace {

class Relay : public RTT::TaskContext {
public:
    explicit Relay(const std::string& name) : TaskContext(name), in_("in"), out_("out") {
        addPort(in_);
        addPort(out_);
        addProperty("last", last_);
    }
    void updateHook() override {
        if (in_.read(last_) == RTT::NewData) out_.write(last_);
    }

private:
    RTT::InputPort<identity::Sample> in_;
    RTT::OutputPort<identity::Sample> out_;
    identity::Sample last_;
};

}

extern "C" {
RTT_EXPORT const void* typeInfoSeenHere() { return RTT::internal::DataSource<identity::Sample>::GetTypeInfo(); }
RTT_EXPORT RTT::TaskContext* makeRelay() { return new Relay("relay"); }
RTT_EXPORT void stepRelay(RTT::TaskContext* relay) { static_cast<Relay*>(relay)->updateHook(); }
}
