// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Exports one component type, while that of its other source file was compiled without RTT_COMPONENT.
#include <rtt/Component.hpp>

namespace loading_test {

class Mixed : public RTT::TaskContext {
public:
    explicit Mixed(const std::string& name) : RTT::TaskContext(name) {}
};

}  // namespace loading_test

ORO_CREATE_COMPONENT(loading_test::Mixed)
