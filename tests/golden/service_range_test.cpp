// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The range of a service's values, which its own code asks for: whether that tells what the manifest says.
#include <gripper/RecorderBase.hpp>

#include <gtest/gtest.h>

namespace {

struct Recorder : gripper::RecorderBase {
    using RecorderBase::RecorderBase;
    using RecorderBase::valuesAreInRange;
    void forget() override {}
    double mean() override { return 0.0; }
};

TEST(ServiceRange, IsAskedForByTheService) {
    RTT::TaskContext owner("owner");
    Recorder recorder(&owner);
    auto* size = dynamic_cast<RTT::Property<unsigned int>*>(recorder.getProperty("size"));
    ASSERT_NE(size, nullptr);

    EXPECT_TRUE(recorder.valuesAreInRange());
    size->set(1000);
    EXPECT_TRUE(recorder.valuesAreInRange());
    size->set(1001);
    EXPECT_FALSE(recorder.valuesAreInRange());
    size->set(0);
    EXPECT_FALSE(recorder.valuesAreInRange());
}

TEST(ServiceRange, CanBeAskedForWithoutAComponent) {
    Recorder recorder(nullptr);
    EXPECT_TRUE(recorder.valuesAreInRange());
}

}  // namespace
