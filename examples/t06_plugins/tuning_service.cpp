// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A service that any component can load: it scales a property of the component, whatever its type.
#include <rtt/TaskContext.hpp>
#include <rtt/plugin/ServicePlugin.hpp>
#include <rtt/types/Operators.hpp>

namespace control {

class Tuning : public RTT::Service {
public:
    explicit Tuning(RTT::TaskContext* owner) : RTT::Service("tuning", owner) {
        doc("Scales properties of its component.");
        addOperation("scale", &Tuning::scale, this)
            .doc("Multiplies a property.")
            .arg("property", "name")
            .arg("factor", "what to multiply it by");
    }

private:
    /** False if there is no such property, or its type has no operator for it. */
    bool scale(const std::string& name, double factor) {
        RTT::base::PropertyBase* const property = getOwner()->getProperty(name);
        if (!property) return false;
        const auto scaled = RTT::types::operators()->applyBinary("*", property->getDataSource().get(),
                                                                 new RTT::internal::ConstantDataSource<double>(factor));
        return scaled && property->getDataSource()->update(scaled);
    }
};

}  // namespace control

ORO_SERVICE_NAMED_PLUGIN(control::Tuning, "tuning")
