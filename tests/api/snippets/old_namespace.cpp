// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// As packages do that are older than version 2.
#include <rtt/RTT.hpp>

#include <gtest/gtest.h>

namespace Orocos {

class OldComponent : public TaskContext {
public:
    OldComponent() : TaskContext("old") {}
};

}  // namespace Orocos

TEST(UserCode, KnowsTheOldNamespace) {
    using namespace Orocos;
    Orocos::OldComponent component;
    Orocos::InputPort<double> port("port");
    component.addPort(port);
    RTT::TaskContext& same = component;
    EXPECT_EQ(same.getPort("port"), &port);
    Orocos::log(Orocos::Debug) << "nested: " << Orocos::os::TimeService::Instance()->getTicks() << Orocos::endlog();
}
