// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The typekit `ocl`: the types of the component library.
#include <ocl/LoggingEvent.hpp>
#include <rtt/types/TypekitPlugin.hpp>

namespace {

class OclTypes : public RTT::types::TypekitPlugin {
public:
    bool loadTypes() override { return OCL::logging::addLoggingTypes(); }
    bool loadConstructors() override { return true; }
    bool loadOperators() override { return true; }
    std::string getName() override { return "ocl"; }
};

}  // namespace

ORO_TYPEKIT_PLUGIN(OclTypes)
