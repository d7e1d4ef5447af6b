// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A typekit by hand.
#include "Climate.hpp"

#include <rtt/types/StructTypeInfo.hpp>
#include <rtt/types/TypekitPlugin.hpp>
#include <rtt/types/Types.hpp>

#include <boost/serialization/nvp.hpp>

namespace boost::serialization {

template <class Archive>
void serialize(Archive& archive, greenhouse::Climate& climate, unsigned int) {
    archive& make_nvp("temperature", climate.temperature);
}

}  // namespace boost::serialization

namespace greenhouse {

class Typekit : public RTT::types::TypekitPlugin {
public:
    std::string getName() override { return "greenhouse"; }
    bool loadTypes() override {
        return RTT::types::Types()->addType(new RTT::types::StructTypeInfo<Climate>("/greenhouse/Climate"));
    }
    bool loadConstructors() override { return true; }
    bool loadOperators() override { return true; }
};

}  // namespace greenhouse

ORO_TYPEKIT_PLUGIN(greenhouse::Typekit)
