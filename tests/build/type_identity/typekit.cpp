// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Built twice, as two plugins that both bring the same type (and its templates), one under TYPE_NAME a, one under b.
#include "shared_type.hpp"

#include <rtt/types/GeneratedTypekit.hpp>
#include <rtt/types/TypekitPlugin.hpp>
#include <rtt/types/Types.hpp>

#include <cstddef>

namespace {

using namespace RTT::types;

constexpr Member members[] = {
    {"value", offsetof(identity::Sample, value), &typeRef<double>, 0, "", ""},
    {"history", offsetof(identity::Sample, history), &typeRef<std::vector<double>>, 0, "", ""},
};

class IdentityTypekit : public TypekitPlugin {
public:
    bool loadTypes() override {
        return Types()->addType(makeStructType<identity::Sample>(TYPE_NAME, members, 2)) &&
               Types()->addType(makeSequenceType<std::vector<double>>("/std/vector</double>"));
    }
    bool loadConstructors() override { return true; }
    bool loadOperators() override { return true; }
    std::string getName() override { return std::string("identity-") + TYPE_NAME; }
};

}

ORO_TYPEKIT_PLUGIN(IdentityTypekit)

template class RTT::OutputPort<identity::Sample>;
template class RTT::InputPort<identity::Sample>;
template class RTT::Property<identity::Sample>;
template class RTT::internal::ValueDataSource<identity::Sample>;

// What the test asks this plugin for: its own idea of the type, and ports made by its own templates.
extern "C" {
RTT_EXPORT const void* typeInfoSeenHere() { return RTT::internal::DataSource<identity::Sample>::GetTypeInfo(); }
RTT_EXPORT RTT::base::OutputPortInterface* makeOutput() { return new RTT::OutputPort<identity::Sample>("out"); }
RTT_EXPORT RTT::base::InputPortInterface* makeInput() { return new RTT::InputPort<identity::Sample>("in"); }
RTT_EXPORT RTT::base::PropertyBase* makeProperty() { return new RTT::Property<identity::Sample>("p", "", {}); }
RTT_EXPORT bool isSampleProperty(RTT::base::PropertyBase* property) {
    return RTT::Property<identity::Sample>::narrow(property) != nullptr;
}
RTT_EXPORT bool writeValue(RTT::base::OutputPortInterface* port, double value) {
    auto* typed = dynamic_cast<RTT::OutputPort<identity::Sample>*>(port);
    identity::Sample sample;
    sample.value = value;
    return typed && typed->write(sample) == RTT::WriteSuccess;
}
RTT_EXPORT double readValue(RTT::base::InputPortInterface* port) {
    auto* typed = dynamic_cast<RTT::InputPort<identity::Sample>*>(port);
    identity::Sample sample;
    return typed && typed->read(sample) == RTT::NewData ? sample.value : -1;
}
}
