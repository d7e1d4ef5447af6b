// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "Pose.hpp"

#include <rtt/types/StructTypeInfo.hpp>
#include <rtt/types/TypekitPlugin.hpp>
#include <rtt/types/Types.hpp>

#include <boost/serialization/nvp.hpp>

namespace boost::serialization {

template <class Archive>
void serialize(Archive& archive, replaytest::Pose& pose, unsigned int) {
    archive& make_nvp("x", pose.x);
#ifdef REPLAYTEST_CHANGED
    archive& make_nvp("quality", pose.quality);
#endif
}

}  // namespace boost::serialization

namespace replaytest {

class Typekit : public RTT::types::TypekitPlugin {
public:
    std::string getName() override { return "replaytest"; }
    bool loadTypes() override {
        return RTT::types::Types()->addType(new RTT::types::StructTypeInfo<Pose>("/replaytest/Pose"));
    }
    bool loadConstructors() override { return true; }
    bool loadOperators() override { return true; }
};

}  // namespace replaytest

ORO_TYPEKIT_PLUGIN(replaytest::Typekit)
