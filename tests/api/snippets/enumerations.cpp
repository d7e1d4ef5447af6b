// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Numbers that scripts, files and other processes know.
#include <rtt/RTT.hpp>
#include <rtt/SendStatus.hpp>

#include <gtest/gtest.h>

using namespace RTT;

static_assert(TaskContext::Init == 0 && TaskContext::PreOperational == 1 && TaskContext::FatalError == 2 &&
              TaskContext::Exception == 3 && TaskContext::Stopped == 4 && TaskContext::Running == 5 &&
              TaskContext::RunTimeError == 6);
static_assert(NoData == 0 && OldData == 1 && NewData == 2);
static_assert(WriteSuccess == 0 && WriteFailure == 1 && NotConnected == 2);
static_assert(CollectFailure == -2 && SendFailure == -1 && SendNotReady == 0 && SendSuccess == 1);
static_assert(ConnPolicy::UNBUFFERED == -1 && ConnPolicy::DATA == 0 && ConnPolicy::BUFFER == 1 &&
              ConnPolicy::CIRCULAR_BUFFER == 2);
static_assert(ConnPolicy::UNSYNC == 0 && ConnPolicy::LOCKED == 1 && ConnPolicy::LOCK_FREE == 2);
static_assert(ConnPolicy::PUSH == false && ConnPolicy::PULL == true);
static_assert(UnspecifiedBufferPolicy == 0 && PerConnection == 1 && PerInputPort == 2 && PerOutputPort == 3 &&
              Shared == 4);
static_assert(OwnThread == 0 && ClientThread == 1);
static_assert(Logger::Never == 0 && Logger::Fatal == 1 && Logger::Critical == 2 && Logger::Error == 3 &&
              Logger::Warning == 4 && Logger::Info == 5 && Logger::Debug == 6 && Logger::RealTime == 7);
static_assert(RTT::Never == 0 && RTT::RealTime == 7);
static_assert(RTT_VERSION_GTE(2, 8, 99) && RTT_VERSION_GTE(2, 9, 0) && !RTT_VERSION_GTE(3, 0, 0));
static_assert(RTT_VERSION_MAJOR * 100 + RTT_VERSION_MINOR >= 206);

TEST(UserCode, ComparesStates) {
    FlowStatus none = NoData, some = OldData;
    EXPECT_FALSE(none);
    EXPECT_TRUE(some && some < NewData);
    TaskContext task("task", TaskContext::PreOperational);
    EXPECT_LT(task.getTaskState(), TaskContext::Stopped);
}
