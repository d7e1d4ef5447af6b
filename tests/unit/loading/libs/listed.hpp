// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_LOADING_LISTED_HPP
#define OROFORGE_TESTS_LOADING_LISTED_HPP

#include <rtt/Component.hpp>

namespace loading_test {

template <class A, class B>
class Pair : public RTT::TaskContext {
public:
    explicit Pair(const std::string& name) : RTT::TaskContext(name) {}
};

}  // namespace loading_test

#endif
