// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Two processes, one of which is killed, stopped and started again.
#include "raw_queue.hpp"
#include "transport_fixture.hpp"

#include <support/child_process.hpp>

#include <csignal>
#include <memory>
#include <string>

using oroforge::test::ChildProcess;
using oroforge::test::Command;
using transport_test::queueName;
using transport_test::RawQueue;

namespace {

constexpr std::chrono::seconds kLimit(20);

class MqueueProcesses : public transport_test::WithTypes {
protected:
    ~MqueueProcesses() override { mq_unlink(name.c_str()); }
    std::unique_ptr<ChildProcess> start(const std::string& role) const {
        Command command;
        command.program = MQUEUE_PEER;
        command.arguments = {role, name};
        auto child = std::make_unique<ChildProcess>(command);
        EXPECT_TRUE(child->waitForOutput("ready", kLimit)) << role;
        return child;
    }
    /// The process may be killed, which is no failure of the test.
    static void end(std::unique_ptr<ChildProcess>& child, int signal) {
        child->send(signal);
        (void)child->finish();
    }
    const std::string name = queueName("processes");
};

}  // namespace

TEST_F(MqueueProcesses, TalkToEachOther) {
    const auto writer = start("write");
    const auto reader = start("read");
    EXPECT_TRUE(reader->waitForOutput("received 200", kLimit));
}

TEST_F(MqueueProcesses, ASenderThatWasKilledComesBack) {
    auto writer = start("write");
    const auto reader = start("read");
    EXPECT_TRUE(reader->waitForOutput("received 100", kLimit));
    end(writer, SIGKILL);
    EXPECT_TRUE(RawQueue::exists(name)) << "nobody was there to remove it";
    writer = start("write");
    EXPECT_TRUE(reader->waitForOutput("the sender began anew", kLimit));
    EXPECT_TRUE(reader->waitForOutput("received 300", kLimit));
}

TEST_F(MqueueProcesses, AReceiverThatWasKilledComesBack) {
    const auto writer = start("write");
    auto reader = start("read");
    EXPECT_TRUE(reader->waitForOutput("received 100", kLimit));
    end(reader, SIGKILL);
    reader = start("read");
    EXPECT_TRUE(reader->waitForOutput("received 100", kLimit));
}

TEST_F(MqueueProcesses, AStoppedReceiverDoesNotDelayTheSender) {
    const auto writer = start("write");
    auto reader = start("read");
    const auto other = start("read");  // takes its share
    EXPECT_TRUE(reader->waitForOutput("received 100", kLimit));
    reader->send(SIGSTOP);
    EXPECT_TRUE(other->waitForOutput("received 300", kLimit));
    reader->send(SIGCONT);
    EXPECT_TRUE(reader->waitForOutput("received 200", kLimit));
}

TEST_F(MqueueProcesses, AHundredReceiversComeAndGo) {
    const auto writer = start("write");
    for (int i = 0; i != 100; ++i) {
        RTT::ConnPolicy policy = RTT::ConnPolicy::circularBuffer(10);
        policy.transport = 2;
        policy.name_id = name;
        RTT::InputPort<int> in("in");
        ASSERT_TRUE(in.createStream(policy)) << i;
        int sample = 0;
        ASSERT_TRUE(transport_test::readSoon(in, sample)) << i;
    }
}
