// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A library with one component type.
#include <rtt/Component.hpp>

namespace loading_test {

class Single : public RTT::TaskContext {
public:
    explicit Single(const std::string& name) : RTT::TaskContext(name) {}
};

}  // namespace loading_test

/** Something another library can link against. */
RTT_EXPORT int loadingTestSingle();
RTT_EXPORT int loadingTestSingle() { return 1; }

ORO_CREATE_COMPONENT(loading_test::Single)
