// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The component library `common`.
#include <ocl/Component.hpp>
#include <ocl/HMIConsoleOutput.hpp>
#include <ocl/OCL.hpp>

namespace OCL {

/** A component with nothing but what every component has, for scripts to fill. */
class EmptyTaskContext : public RTT::TaskContext {
public:
    explicit EmptyTaskContext(const std::string& name) : RTT::TaskContext(name) {}
};

}  // namespace OCL

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(OCL::HMIConsoleOutput)

namespace {
// Under the name that applications use, which is not that of a class of this library.
const RTT::ComponentFactoryLoader<OCL::EmptyTaskContext> registeredTaskContext("TaskContext");
}  // namespace
