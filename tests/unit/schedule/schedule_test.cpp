// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The order in which a schedule executes components, and that time stands meanwhile.
#include "recorded_times.hpp"

#include <rtt/Activity.hpp>
#include <rtt/OperationCaller.hpp>

#include <gmock/gmock.h>

#include <atomic>
#include <memory>
#include <thread>

namespace {

using namespace schedule_test;
using OCL::schedule::Schedule;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class ScheduleTest : public testing::Test {
protected:
    std::unique_ptr<Noting> periodic(const std::string& name, double period, int priority = 0) {
        auto made = std::make_unique<Noting>(name, events_);
        EXPECT_TRUE(made->setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, period)));
        EXPECT_TRUE(made->getActivity()->thread()->setPriority(priority));
        return made;
    }
    Schedule::Outcome run() { return schedule_.run(times_, never); }

    Events events_;
    Times times_;
    Schedule schedule_{kStart};
};

TEST_F(ScheduleTest, TimeStandsAndMovesToEachPeriodAndMessage) {
    const auto a = periodic("A", 0.01);
    ASSERT_TRUE(a->start());
    times_.at(15, [&] { events_.push_back("message@" + std::to_string(now())); });
    times_.until(30);
    EXPECT_EQ(now(), 0);
    const Schedule::Outcome outcome = run();
    EXPECT_TRUE(outcome.isComplete);
    EXPECT_EQ(outcome.simulated, 30 * kMs);
    EXPECT_THAT(events_, ElementsAre("A@10", "message@15", "A@20", "A@30"));
    EXPECT_EQ(now(), 30);
}

TEST_F(ScheduleTest, PriorityThenCreationThenMessagesThenWhatWasTriggered) {
    const auto first = periodic("first", 0.01), second = periodic("second", 0.01);
    const auto urgent = periodic("urgent", 0.01, 50);
    Noting waiting("waiting", events_);
    first->update = [&] { waiting.trigger(); };
    // The order in which they are started does not count.
    for (RTT::TaskContext* component : {second.get(), first.get(), urgent.get()}) ASSERT_TRUE(component->start());
    ASSERT_TRUE(waiting.start());
    times_.at(10, [&] { events_.push_back("one"); });
    times_.at(10, [&] { events_.push_back("two"); });
    EXPECT_TRUE(run().isComplete);
    EXPECT_THAT(events_, ElementsAre("urgent@10", "first@10", "second@10", "one", "two", "waiting@10"));
}

TEST_F(ScheduleTest, SamplesGoThroughAllComponentsAtOneTime) {
    struct Stage : Noting {
        Stage(const std::string& name, Events& events) : Noting(name, events) {
            addEventPort("in", in);
            addPort("out", out);
            update = [this] {
                double value = 0;
                if (in.read(value) == RTT::NewData) out.write(value + 1);
            };
        }
        RTT::InputPort<double> in;
        RTT::OutputPort<double> out;
    };
    Stage a("A", events_), b("B", events_), c("C", events_);
    RTT::OutputPort<double> source("source");
    RTT::InputPort<double> end("end");
    ASSERT_TRUE(source.connectTo(&a.in));
    ASSERT_TRUE(a.out.connectTo(&b.in));
    ASSERT_TRUE(b.out.connectTo(&c.in));
    ASSERT_TRUE(c.out.connectTo(&end));
    for (Stage* stage : {&a, &b, &c}) ASSERT_TRUE(stage->start());
    times_.at(5, [&] { source.write(1.0); });
    EXPECT_TRUE(run().isComplete);
    EXPECT_THAT(events_, ElementsAre("A@5", "B@5", "C@5"));
    double value = 0;
    EXPECT_EQ(end.read(value), RTT::NewData);
    EXPECT_EQ(value, 4.0);
}

TEST_F(ScheduleTest, ComponentsThatTriggerEachOtherForEverAreNamed) {
    Noting ping("ping", events_), pong("pong", events_), calm("calm", events_);
    ping.update = [&] { pong.trigger(); };
    pong.update = [&] { ping.trigger(); };
    for (Noting* component : {&ping, &pong, &calm}) ASSERT_TRUE(component->start());
    times_.at(1, [&] { ping.trigger(); });
    times_.until(2);
    const Schedule::Outcome outcome = run();
    EXPECT_FALSE(outcome.isComplete);
    EXPECT_THAT(outcome.error, HasSubstr("'ping', 'pong' trigger each other"));
    EXPECT_EQ(now(), 1);
    ping.update = pong.update = nullptr;
}

TEST_F(ScheduleTest, PeriodChangesWhileItRuns) {
    const auto a = periodic("A", 0.01);
    a->update = [&] {
        if (now() == 20) {
            EXPECT_TRUE(a->setPeriod(0.005));
        }
    };
    ASSERT_TRUE(a->start());
    times_.until(30);
    run();
    EXPECT_THAT(events_, ElementsAre("A@10", "A@20", "A@25", "A@30"));
    EXPECT_EQ(a->getPeriod(), 0.005);
}

TEST_F(ScheduleTest, HooksStopAndStartComponents) {
    const auto a = periodic("A", 0.01), b = periodic("B", 0.01);
    a->update = [&] {
        if (now() == 20) {
            EXPECT_TRUE(b->stop());
        }
        if (now() == 40) {
            EXPECT_TRUE(b->start());
        }
        if (now() == 50) {
            EXPECT_TRUE(a->stop());
        }
    };
    ASSERT_TRUE(a->start());
    ASSERT_TRUE(b->start());
    times_.until(70);
    run();
    EXPECT_THAT(events_, ElementsAre("A@10", "B@10", "A@20", "A@30", "A@40", "B@40", "A@50", "B@50", "B@60", "B@70"));
}

TEST_F(ScheduleTest, ComponentsAreDeletedWhileTheyAreDue) {
    const auto a = periodic("A", 0.01);
    auto b = periodic("B", 0.01);
    auto c = std::make_unique<Noting>("C", events_);
    a->update = [&] {
        if (now() == 20) c->trigger();
        if (now() == 20) b.reset(), c.reset();
    };
    for (RTT::TaskContext* component :
         {static_cast<RTT::TaskContext*>(a.get()), static_cast<RTT::TaskContext*>(b.get()),
          static_cast<RTT::TaskContext*>(c.get())})
        ASSERT_TRUE(component->start());
    times_.until(40);
    EXPECT_TRUE(run().isComplete);
    EXPECT_THAT(events_, ElementsAre("A@10", "B@10", "A@20", "A@30", "A@40"));
}

TEST_F(ScheduleTest, AComponentIsDeletedInItsOwnStep) {
    const auto a = periodic("A", 0.01);
    auto b = std::make_unique<Noting>("B", events_);
    ASSERT_TRUE(b->setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, 0.01)));
    struct Message : RTT::base::DisposableInterface {
        std::unique_ptr<Noting>& victim;
        explicit Message(std::unique_ptr<Noting>& toDelete) : victim(toDelete) {}
        void executeAndDispose() override {
            victim.reset();
            delete this;
        }
        void dispose() override { delete this; }
    };
    ASSERT_TRUE(a->start());
    ASSERT_TRUE(b->start());
    times_.at(15, [&] { ASSERT_TRUE(b->engine()->process(new Message(b))); });
    times_.until(30);
    EXPECT_TRUE(run().isComplete);
    EXPECT_FALSE(b);
    EXPECT_THAT(events_, ElementsAre("A@10", "B@10", "A@20", "A@30"));
}

TEST_F(ScheduleTest, OperationsOfOthersAreCalledAndCollected) {
    struct Server : RTT::TaskContext {
        Server() : RTT::TaskContext("server") { addOperation("twice", &Server::twice, this, RTT::OwnThread); }
        ~Server() override { stopForGood(); }
        int twice(int value) { return 2 * value; }
    } server;
    ASSERT_TRUE(server.start());
    const auto client = periodic("client", 0.01);
    RTT::OperationCaller<int(int)> twice(server.getOperation("twice"), client->engine());
    int called = 0, collected = 0;
    client->update = [&] {
        called = twice(21);
        RTT::SendHandle<int(int)> handle = twice.send(4);
        if (handle.collect(collected) != RTT::SendSuccess) collected = -1;
    };
    ASSERT_TRUE(client->start());
    times_.until(10);
    EXPECT_TRUE(run().isComplete);
    EXPECT_EQ(called, 42);
    EXPECT_EQ(collected, 8);
    // The thread of the schedule itself, as a script does.
    RTT::SendHandle<int(int)> handle =
        RTT::OperationCaller<int(int)>(server.getOperation("twice"), server.engine()).send(5);
    EXPECT_EQ(handle.collect(collected), RTT::SendSuccess);
    EXPECT_EQ(collected, 10);
}

TEST_F(ScheduleTest, OthersThreadsMayTriggerAndAreCounted) {
    Noting a("A", events_);
    ASSERT_TRUE(a.start());
    times_.at(10, [&] { std::thread([&] { a.trigger(); }).join(); });
    EXPECT_TRUE(run().isComplete);
    EXPECT_THAT(events_, ElementsAre("A@10"));
    EXPECT_THAT(schedule_.triggeredByOthers(), ElementsAre(testing::Pair("A", 1)));
}

TEST_F(ScheduleTest, ThreadsTriggerStartAndStopMeanwhile) {
    Noting a("A", events_), b("B", events_);
    ASSERT_TRUE(b.setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, 0.001)));
    ASSERT_TRUE(a.start());
    std::atomic<bool> ends{false};
    std::atomic<unsigned> triggers{0}, starts{0};
    std::thread trigger([&] {
        for (; !ends; ++triggers) a.trigger();
    });
    std::thread starter([&] {
        for (; !ends; ++starts) {
            (void)b.start();
            (void)b.stop();
        }
    });
    // Both threads do something during the run.
    for (const long time : {1, 250, 499})
        times_.at(time, [&] {
            const unsigned triggersNow = triggers, startsNow = starts;
            while (triggers - triggersNow < 20 || starts - startsNow < 20) std::this_thread::yield();
        });
    times_.until(500);
    EXPECT_TRUE(run().isComplete);
    ends = true;
    trigger.join();
    starter.join();
    EXPECT_THAT(schedule_.triggeredByOthers(), testing::Not(IsEmpty()));
}

TEST_F(ScheduleTest, TheLastOneSeesAllOfATimeAtOnce) {
    Noting a("A", events_), recorder("recorder", events_), b("B", events_);
    a.update = [&] {
        recorder.trigger();
        b.trigger();
    };
    b.update = [&] { recorder.trigger(); };
    for (Noting* component : {&a, &recorder, &b}) ASSERT_TRUE(component->start());
    schedule_.executeLast(recorder);
    times_.at(3, [&] { a.trigger(); });
    EXPECT_TRUE(run().isComplete);
    EXPECT_THAT(events_, ElementsAre("A@3", "B@3", "recorder@3"));
}

TEST_F(ScheduleTest, AnInterruptionEndsIt) {
    const auto a = periodic("A", 0.01);
    ASSERT_TRUE(a->start());
    times_.until(1000);
    const Schedule::Outcome outcome = schedule_.run(times_, [&] { return now() >= 20; });
    EXPECT_FALSE(outcome.isComplete);
    EXPECT_THAT(outcome.error, IsEmpty());
    EXPECT_THAT(events_, ElementsAre("A@10", "A@20"));
}

TEST_F(ScheduleTest, TheSpeedIsKept) {
    schedule_.setSpeed(2);
    times_.until(100);
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_TRUE(run().isComplete);
    EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(49));
}

}  // namespace
