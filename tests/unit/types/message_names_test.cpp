// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/types/MessageNames.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace RTT::types;

TEST(MessageNames, areKeptAndTold) {
    EXPECT_EQ(announcedMessage("/names/A"), nullptr);
    EXPECT_TRUE(announceMessage("/names/A", "demo_msgs/A", "0a", "int8 x"));
    EXPECT_TRUE(announceMessage("/names/A", "demo_msgs/A", "0a", "int8 x")) << "two typekits may have the type";
    EXPECT_FALSE(announceMessage("/names/A", "demo_msgs/B", "0a", ""));
    EXPECT_FALSE(announceMessage("/names/A", "demo_msgs/A", "0b", ""));
    const auto told = std::make_shared<std::vector<std::string>>();
    watchMessages([told](const MessageName& one) {
        if (one.type.rfind("/names/", 0) == 0) told->push_back(one.type);
    });
    EXPECT_TRUE(announceMessage("/names/B", "demo_msgs/B", "0b", "int8 y"));
    EXPECT_TRUE(announceMessage("/names/B", "demo_msgs/B", "0b", "int8 y"));
    EXPECT_EQ(*told, (std::vector<std::string>{"/names/A", "/names/B"}));
    ASSERT_TRUE(announcedMessage("/names/A"));
    EXPECT_EQ(announcedMessage("/names/A")->definition, "int8 x");
}

TEST(MessageNames, eachIsToldOnceWhileOthersAnnounce) {
    const auto told = std::make_shared<std::atomic<int>>(0);
    const auto announce = [](const std::string& prefix) {
        for (int i = 0; i != 200; ++i)
            EXPECT_TRUE(announceMessage((prefix + std::to_string(i)).c_str(), "demo_msgs/A", "0a", ""));
    };
    std::thread one(announce, "/one/"), other(announce, "/other/");
    watchMessages([told](const MessageName& name) {
        if (name.type.rfind("/names/", 0) != 0) ++*told;
    });
    one.join();
    other.join();
    EXPECT_EQ(*told, 400);
}

}  // namespace
