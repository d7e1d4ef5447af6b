// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/ConnPolicy.hpp>
#include <rtt/FlowStatus.hpp>

#include <gtest/gtest.h>

#include <sstream>

using namespace RTT;

namespace {
template <class T>
std::string text(const T& value) {
    std::ostringstream os;
    os << value;
    return os.str();
}
template <class T>
T parsed(const std::string& word, T before) {
    std::istringstream is(word);
    is >> before;
    return before;
}
}  // namespace

TEST(ConnPolicy, IsLockFreePushDataPerConnectionByDefault) {
    const ConnPolicy policy;
    EXPECT_EQ(policy.type, ConnPolicy::DATA);
    EXPECT_EQ(policy.lock_policy, ConnPolicy::LOCK_FREE);
    EXPECT_EQ(policy.size, 0);
    EXPECT_FALSE(policy.init);
    EXPECT_FALSE(policy.pull);
    EXPECT_EQ(policy.buffer_policy, PerConnection);
    EXPECT_EQ(policy.max_threads, 0);
    EXPECT_TRUE(policy.mandatory);
    EXPECT_EQ(policy.transport, 0);
}

TEST(ConnPolicy, FactoriesDifferInInit) {
    EXPECT_TRUE(ConnPolicy::data().init);
    EXPECT_FALSE(ConnPolicy::buffer(3).init);
    EXPECT_FALSE(ConnPolicy::circularBuffer(3).init);
    EXPECT_EQ(ConnPolicy::buffer(3).size, 3);
    EXPECT_EQ(ConnPolicy::circularBuffer(3).type, ConnPolicy::CIRCULAR_BUFFER);
    EXPECT_EQ(ConnPolicy::data(ConnPolicy::LOCKED).lock_policy, ConnPolicy::LOCKED);
    EXPECT_TRUE(ConnPolicy::data(ConnPolicy::LOCKED, false, ConnPolicy::PULL).pull);
}

TEST(ConnPolicy, StartsFromTheProcessWideDefaultButNotFromItsName) {
    const ConnPolicy saved = ConnPolicy::Default();
    ConnPolicy::Default().mandatory = false;
    ConnPolicy::Default().transport = 3;
    ConnPolicy::Default().name_id = "never taken";
    const ConnPolicy made, buffer = ConnPolicy::buffer(3);
    ConnPolicy::Default() = saved;
    EXPECT_FALSE(made.mandatory);
    EXPECT_EQ(buffer.transport, 3);
    EXPECT_EQ(made.name_id, "");
    EXPECT_TRUE(ConnPolicy().mandatory);
}

TEST(ConnPolicy, PrintsItself) {
    EXPECT_EQ(text(ConnPolicy()), "PUSH PerConnection LOCK_FREE DATA");
    ConnPolicy policy = ConnPolicy::buffer(10, ConnPolicy::LOCKED, false, ConnPolicy::PULL);
    policy.name_id = "/chat";
    policy.max_threads = 4;
    policy.buffer_policy = Shared;
    EXPECT_EQ(text(policy), "PULL Shared LOCKED BUFFER[10] (name_id=/chat) (max_threads=4)");
}

TEST(BufferPolicy, IsPrintedAndReadByName) {
    EXPECT_EQ(text(PerInputPort), "PerInputPort");
    EXPECT_EQ(text(UnspecifiedBufferPolicy), "(unspecified buffer policy)");
    EXPECT_EQ(text(static_cast<BufferPolicy>(7)), "(unknown buffer policy)");
    EXPECT_EQ(parsed("PerOutputPort", Shared), PerOutputPort);
    EXPECT_EQ(parsed("nonsense", Shared), UnspecifiedBufferPolicy);
}

TEST(FlowStatus, IsPrintedAndReadByName) {
    EXPECT_EQ(text(NoData) + text(OldData) + text(NewData), "NoDataOldDataNewData");
    EXPECT_EQ(parsed("OldData", NewData), OldData);
    EXPECT_EQ(parsed("nonsense", NewData), NoData);
}

TEST(WriteStatus, IsPrintedAndReadByName) {
    EXPECT_EQ(text(WriteSuccess) + text(WriteFailure) + text(NotConnected), "WriteSuccessWriteFailureNotConnected");
    EXPECT_EQ(parsed("NotConnected", WriteSuccess), NotConnected);
    EXPECT_EQ(parsed("nonsense", NotConnected), WriteSuccess);
}
