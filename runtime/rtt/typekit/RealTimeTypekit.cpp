// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "RealTimeTypekit.hpp"

#include <rtt/typekit/detail/builtin_parts.hpp>

namespace RTT::types {

bool RealTimeTypekitPlugin::loadTypes() {
    builtin::addFundamentalTypes();
    builtin::addSmallNumbers();
    builtin::addTexts();
    builtin::addBags();
    builtin::addStatusTypes();
    builtin::addPolicies();
    builtin::addComponentTypes();
    return true;
}

bool RealTimeTypekitPlugin::loadConstructors() {
    builtin::addNumberConversions();
    builtin::addOtherConversions();
    return true;
}

bool RealTimeTypekitPlugin::loadOperators() {
    builtin::addNumberOperators();
    builtin::addTextOperators();
    return true;
}

bool RealTimeTypekitPlugin::loadGlobals() {
    builtin::addGlobals();
    return true;
}

std::string RealTimeTypekitPlugin::getName() { return "rtt-types"; }

}  // namespace RTT::types

ORO_TYPEKIT_PLUGIN(RTT::types::RealTimeTypekitPlugin)
