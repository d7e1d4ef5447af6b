// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A library that was linked without what it needs.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>

namespace deploybroken {

int definedNowhere();

class Broken : public RTT::TaskContext {
public:
    explicit Broken(const std::string& name) : RTT::TaskContext(name) { addAttribute("value", value_); }

private:
    int value_ = definedNowhere();
};

}  // namespace deploybroken

ORO_CREATE_COMPONENT(deploybroken::Broken)
