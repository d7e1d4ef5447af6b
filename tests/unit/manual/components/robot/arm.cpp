// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A library of one component type. The constructor is where the class is; the macro stands at the end, with the namespace.
#include <rtt/TaskContext.hpp>

#include <ocl/Component.hpp>

namespace robot {

class Arm : public RTT::TaskContext {
public:
    explicit Arm(const std::string& name) : RTT::TaskContext(name) {}
};

}  // namespace robot

ORO_CREATE_COMPONENT(robot::Arm)
