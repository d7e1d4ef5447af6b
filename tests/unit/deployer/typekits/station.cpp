// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component library that describes its component as generated ones do, and uses a type of another package's typekit.
#include "Climate.hpp"

#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>
#include <rtt/internal/ComponentDescription.hpp>

namespace station {

class Station : public RTT::TaskContext {
public:
    explicit Station(const std::string& name) : RTT::TaskContext(name) {
        addPort("climate", climate_);
        addPort("inner", inner_);
        addProperty("limits", limits_);
    }
    ~Station() override { stopForGood(); }

private:
    RTT::OutputPort<greenhouse::Climate> climate_;
    RTT::OutputPort<greenhouse::Private> inner_;
    greenhouse::Climate limits_;
};

namespace {

using namespace RTT::internal;

constexpr DescribedPort kPorts[] = {{"climate", &typeid(greenhouse::Climate), true},
                                    {"inner", &typeid(greenhouse::Private), true}};
constexpr DescribedProperty kProperties[] = {{"limits", &typeid(greenhouse::Climate)}};
constexpr ComponentDescription kComponents[] = {{"station::Station", "station", kPorts, kProperties, false}};
const ComponentDescriptions known{kComponents};

}  // namespace
}  // namespace station

ORO_CREATE_COMPONENT(station::Station)
