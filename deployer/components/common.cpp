// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The component library `common`.
#include <fbsched/fbsched.hpp>
#include <ocl/Chain.hpp>
#include <ocl/Component.hpp>
#include <ocl/HMIConsoleOutput.hpp>
#include <ocl/OCL.hpp>

namespace OCL {

/** An empty component, to be filled by scripts. */
class EmptyTaskContext : public RTT::TaskContext {
public:
    explicit EmptyTaskContext(const std::string& name) : RTT::TaskContext(name) {}
};

}  // namespace OCL

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(OCL::HMIConsoleOutput)
ORO_LIST_COMPONENT_TYPE(OCL::Chain)
ORO_LIST_COMPONENT_TYPE(FBSched)

namespace {
// Applications use this name, though no class of this library has it.
const RTT::ComponentFactoryLoader<OCL::EmptyTaskContext> registeredTaskContext("TaskContext");
ORO_COMPONENT_NAME_IN_FILE_(TaskContext)  // so that it is found without loading all
}  // namespace
