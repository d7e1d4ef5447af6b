// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Names of frames, malformed transforms, and what is logged once.
#include <rtt_tf/detail/frame_names.hpp>
#include <rtt_tf/detail/reported.hpp>
#include <rtt_tf/detail/transform_check.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace rtt_tf::detail;
using testing::HasSubstr;

geometry_msgs::TransformStamped fine() {
    geometry_msgs::TransformStamped made;
    made.header.frame_id = "world";
    made.child_frame_id = "base";
    made.transform.rotation.w = 1;
    return made;
}

TEST(FrameNames, APrefixGoesBeforeFramesThatAreNotGlobal) {
    EXPECT_EQ("robot1/base", prefixed("robot1", "base"));
    EXPECT_EQ("map", prefixed("robot1", "/map"));
    EXPECT_EQ("base", prefixed("", "base"));
    EXPECT_EQ("", prefixed("robot1", ""));
    EXPECT_EQ("robot1", trimmed("//robot1/"));
    EXPECT_EQ("", trimmed("/"));
    EXPECT_EQ("", bare("/"));
}

TEST(TransformCheck, AFineTransformIsNotRefused) { EXPECT_FALSE(check(fine())); }

TEST(TransformCheck, NamesAreNeeded) {
    auto transform = fine();
    transform.child_frame_id = "";
    EXPECT_THAT(check(transform).text, HasSubstr("empty child_frame_id"));
    transform = fine();
    transform.header.frame_id = "";
    EXPECT_THAT(check(transform).text, HasSubstr("empty header.frame_id"));
    transform.header.frame_id = "base";
    EXPECT_EQ(Refusal::Same, check(transform).kind);
}

TEST(TransformCheck, ValuesAreFinite) {
    auto transform = fine();
    transform.transform.translation.y = NAN;
    EXPECT_THAT(check(transform).text, HasSubstr("translation 0 nan 0"));
    transform = fine();
    transform.transform.rotation.x = INFINITY;
    EXPECT_EQ(Refusal::NotFinite, check(transform).kind);
    transform.transform.rotation.x = 1e200;
    EXPECT_EQ(Refusal::NotUnit, check(transform).kind);
}

TEST(TransformCheck, ARotationHasTheLengthOne) {
    auto transform = fine();
    transform.transform.rotation.w = 0;
    EXPECT_THAT(check(transform).text, HasSubstr("a rotation of length 0; use a quaternion of length 1"));
    transform.transform.rotation.w = 1.003;
    EXPECT_FALSE(check(transform));
}

TEST(Reported, AReasonIsNewOnceUntilItWorks) {
    Reported reported;
    EXPECT_TRUE(reported.isEmpty());
    EXPECT_TRUE(reported.isNew("a", 1));
    EXPECT_FALSE(reported.isNew("a", 1));
    EXPECT_TRUE(reported.isNew("a", 2));
    EXPECT_TRUE(reported.isNew("b", 1));
    reported.works("a");
    EXPECT_TRUE(reported.isNew("a", 1));
    EXPECT_FALSE(reported.isNew("b", 1));
    EXPECT_FALSE(reported.isEmpty());
}

TEST(Reported, EndlessSubjectsDoNotFillTheLog) {
    Reported reported;
    int lines = 0;
    for (int i = 0; i != 1000; ++i) lines += reported.isNew(std::to_string(i), 1);
    EXPECT_EQ(256, lines);
}

TEST(Reported, OfSeveralThreadsOneIsFirst) {
    Reported reported;
    std::atomic<int> first{0};
    std::vector<std::thread> threads;
    for (int i = 0; i != 4; ++i)
        threads.emplace_back([&] {
            for (int subject = 0; subject != 100; ++subject) first += reported.isNew(std::to_string(subject), 1);
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(100, first);
}

}  // namespace
