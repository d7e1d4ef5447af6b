// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The second file of the library: lists its type, and no more.
#include <rtt/TaskContext.hpp>

#include <ocl/Component.hpp>

namespace Robot13 {

class Diagnostics : public RTT::TaskContext {
public:
    explicit Diagnostics(const std::string& name) : RTT::TaskContext(name) {}
};

}  // namespace Robot13

ORO_LIST_COMPONENT_TYPE(Robot13::Diagnostics)
