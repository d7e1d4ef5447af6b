// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A library with several component types, which links the library with one.
#include <rtt/Component.hpp>

#include <stdexcept>

int loadingTestSingle();

namespace loading_test {

class First : public RTT::TaskContext {
public:
    explicit First(std::string name) : RTT::TaskContext(name) { addAttribute("linked", linked_); }

private:
    int linked_ = loadingTestSingle();
};

class Throwing : public RTT::TaskContext {
public:
    explicit Throwing(std::string name) : RTT::TaskContext(name) {
        throw std::runtime_error("no hardware at address 7");
    }
};

}  // namespace loading_test

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(loading_test::First)
ORO_LIST_COMPONENT_TYPE(loading_test::Throwing)
