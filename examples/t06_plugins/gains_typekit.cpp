// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A typekit by hand, without typegen: members by boost.serialization, a constructor, an operator.
#include "gains.hpp"

#include <rtt/types/OperatorTypes.hpp>
#include <rtt/types/Operators.hpp>
#include <rtt/types/StructTypeInfo.hpp>
#include <rtt/types/TemplateConstructor.hpp>
#include <rtt/types/TypekitPlugin.hpp>
#include <rtt/types/Types.hpp>

#include <boost/serialization/serialization.hpp>
#include <boost/serialization/vector.hpp>

namespace boost::serialization {

template <class Archive>
void serialize(Archive& archive, control::Gains& gains, unsigned int) {
    archive& make_nvp("p", gains.p);
    archive& make_nvp("i", gains.i);
    archive& make_nvp("d", gains.d);
    archive& make_nvp("limits", gains.limits);
}

}  // namespace boost::serialization

namespace control {

namespace {

Gains proportional(double p) { return Gains{p, 0, 0, {}}; }

struct Scale {
    typedef Gains first_argument_type;
    typedef double second_argument_type;
    typedef Gains result_type;
    Gains operator()(const Gains& gains, double factor) const {
        return Gains{gains.p * factor, gains.i * factor, gains.d * factor, gains.limits};
    }
};

class GainsTypekit : public RTT::types::TypekitPlugin {
public:
    std::string getName() override { return "control-gains"; }
    bool loadTypes() override {
        RTT::types::Types()->addType(new RTT::types::StructTypeInfo<Gains>("Gains"));
        return true;
    }
    bool loadConstructors() override {
        RTT::types::Types()->type("Gains")->addConstructor(RTT::types::newConstructor(&proportional));
        return true;
    }
    bool loadOperators() override {
        RTT::types::operators()->add(RTT::types::newBinaryOperator("*", Scale()));
        return true;
    }
};

}  // namespace

}  // namespace control

ORO_TYPEKIT_PLUGIN(control::GainsTypekit)
