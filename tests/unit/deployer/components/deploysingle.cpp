// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A library with one component type.
#include <rtt/Component.hpp>
#include <rtt/TaskContext.hpp>

namespace deploysingle {
class Single : public RTT::TaskContext {
public:
    explicit Single(const std::string& name) : RTT::TaskContext(name) {}
};
}  // namespace deploysingle

ORO_CREATE_COMPONENT(deploysingle::Single)
