// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component type linked into the program: no RTT_COMPONENT here.
#include <rtt/Component.hpp>

namespace loading_test {

class Linked : public RTT::TaskContext {
public:
    explicit Linked(std::string name) : RTT::TaskContext(name) {}
};

}  // namespace loading_test

ORO_CREATE_COMPONENT(loading_test::Linked)
