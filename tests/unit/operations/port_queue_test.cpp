// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Callbacks of event ports in the queue of a component.
#include "probe.hpp"

#include <rtt/Port.hpp>
#include <rtt/internal/flow/port_callbacks.hpp>

#include <optional>

using namespace RTT;
using internal::Mailbox;
using internal::PortCallbacks;
using oroforge::test::makeManual;
using oroforge::test::Note;
using oroforge::test::Probe;

namespace {

struct PortQueue : testing::Test {
    PortQueue() {
        makeManual(c);
        c.start();
        out.createConnection(in);
    }
    ~PortQueue() override { c.stop(); }
    void listen(std::function<void()> action = {}) {
        c.addEventPort(in, [this, action](base::PortInterface*) {
            ++calls;
            if (action) action();
        });
    }
    void fillMailbox(std::vector<Note>& notes) {
        for (Note& note : notes) ASSERT_TRUE(c.engine()->process(&note));
        Note oneMore;
        ASSERT_FALSE(c.engine()->process(&oneMore));
    }
    int calls = 0;
    InputPort<int> in{"in"};
    OutputPort<int> out{"out"};
    Probe c;
};

}  // namespace

TEST_F(PortQueue, ACallbackForWhichTheQueueHasNoRoomComesLater) {
    listen();
    std::vector<Note> notes(Mailbox::kCapacity);
    fillMailbox(notes);
    EXPECT_EQ(out.write(1), WriteSuccess);
    c.update();
    EXPECT_EQ(calls, 1);
    out.write(2);
    c.update();
    EXPECT_EQ(calls, 2);
}

TEST_F(PortQueue, ACallbackForWhichTheQueueHasNoRoomComesWhenAWaitIsOver) {
    listen();
    std::vector<Note> notes(Mailbox::kCapacity);
    int callsMeanwhile = -1;
    c.onUpdate = [&] {
        if (callsMeanwhile >= 0) return;
        fillMailbox(notes);
        out.write(1);
        c.engine()->waitForMessages([&] { return notes.back().executed == 1; });
        callsMeanwhile = calls;
    };
    c.update();
    EXPECT_EQ(callsMeanwhile, 0);
    c.update();
    EXPECT_EQ(calls, 1);
}

// A thread with its own activity: nothing else wakes it.
TEST_F(PortQueue, ACallbackForWhichTheQueueHasNoRoomWakesTheThread) {
    Probe own("own");
    std::atomic<int> told{0};
    InputPort<int> port;
    own.addEventPort("port", port, [&](base::PortInterface*) { ++told; });
    ASSERT_TRUE(out.createConnection(port));
    ASSERT_TRUE(own.start());
    std::atomic<bool> blocked{false}, go{false};
    Note block([&] {
        blocked = true;
        oroforge::test::eventually([&] { return go.load(); });
    });
    ASSERT_TRUE(own.engine()->process(&block));
    ASSERT_TRUE(oroforge::test::eventually([&] { return blocked.load(); }));
    std::vector<Note> notes(Mailbox::kCapacity);
    for (Note& note : notes) ASSERT_TRUE(own.engine()->process(&note));
    EXPECT_EQ(out.write(1), WriteSuccess);
    go = true;
    EXPECT_TRUE(oroforge::test::eventually([&] { return told == 1; }));
    own.stop();
    own.getActivity()->stop();
}

TEST_F(PortQueue, ACallbackThatFeedsItsPortLetsTheComponentUpdate) {
    c.onUpdate = [this] { c.note(calls < 1000 ? "update" : "late"); };
    listen([this] {
        if (calls < 1000) out.write(calls);
    });
    c.takeHooks();
    out.write(1);
    c.update();
    EXPECT_EQ(c.takeHooks(), "update");
    for (int i = 0; i != 1000 && calls < 1000; ++i) c.update();
    EXPECT_EQ(calls, 1000);
}

TEST_F(PortQueue, AThreadGoesOnWithAQueueThatRefills) {
    Probe own("own");
    std::atomic<int> told{0};
    InputPort<int> port;
    OutputPort<int> self;
    own.addEventPort("port", port, [&](base::PortInterface*) {
        if (++told < 1000) self.write(told);
    });
    ASSERT_TRUE(self.createConnection(port));
    ASSERT_TRUE(own.start());
    self.write(1);
    EXPECT_TRUE(oroforge::test::eventually([&] { return told == 1000; }));
    own.stop();
    own.getActivity()->stop();
}

TEST_F(PortQueue, ANewPortInThePlaceOfADestroyedOneIsNotCalledForIt) {
    std::optional<InputPort<int>> port;
    const auto add = [&] {
        port.emplace("port");
        c.addEventPort(*port, [this](base::PortInterface*) { ++calls; });
        ASSERT_TRUE(out.createConnection(*port));
    };
    add();
    out.write(1);
    add();
    c.update();
    EXPECT_EQ(calls, 0);
    out.write(2);
    c.update();
    EXPECT_EQ(calls, 1);
}

TEST_F(PortQueue, ManyCallbacksThatCameDuringAWaitAreAllMade) {
    std::vector<std::unique_ptr<InputPort<int>>> ports;
    for (int i = 0; i != 40; ++i) {
        ports.emplace_back(new InputPort<int>("port" + std::to_string(i)));
        c.addEventPort(*ports.back(), [this](base::PortInterface*) { ++calls; });
        ASSERT_TRUE(out.createConnection(*ports.back()));
    }
    Note last;
    c.onUpdate = [&] {
        if (last.executed) return;
        out.write(1);
        ASSERT_TRUE(c.engine()->process(&last));
        c.engine()->waitForMessages([&] { return last.executed == 1; });
        EXPECT_EQ(calls, 0);
    };
    c.update();
    c.update();
    EXPECT_EQ(calls, 40);
}

// The thread that was first to announce data has stopped before it could queue the port.
TEST(PortCallbacks, WhoAnnouncesDataDoesNotRelyOnOneWhoHasNotQueuedThePortYet) {
    PortCallbacks callbacks;
    InputPort<int> port("port");
    int calls = 0;
    callbacks.set(&port, [&](base::PortInterface*) { ++calls; });
    const auto first = callbacks.announce(&port, true);
    EXPECT_TRUE(first);
    const auto second = callbacks.announce(&port, true);
    EXPECT_TRUE(second);
    callbacks.queued(&port, second);
    EXPECT_FALSE(callbacks.announce(&port, true));
    callbacks.call(&port, true);
    EXPECT_EQ(calls, 1);
    callbacks.call(&port, true);  // what the first one queued
    EXPECT_EQ(calls, 1);

    const auto third = callbacks.announce(&port, true);
    EXPECT_TRUE(third);
    callbacks.queued(&port, first);  // by the first one, late
    EXPECT_TRUE(callbacks.announce(&port, true));
}
