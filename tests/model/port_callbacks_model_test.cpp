// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/expect.hpp>
#define MODEL_SHARED_POINTERS
#include <model/checker/substitute.hpp>
#include <model/checked_waiting.hpp>

#include <rtt/internal/flow/port_callbacks.cpp>

namespace {

using model::prepareWaiting;
using model::require;
using model::Trial;
using RTT::internal::PortCallbacks;
using RTT::internal::Reclaimer;

/** A port, the queue of its component's engine, and what the callback saw. */
struct Component {
    PortCallbacks callbacks;
    RTT::base::PortInterface* const port = reinterpret_cast<RTT::base::PortInterface*>(&callbacks);
    std::atomic<int> sample{0}, queued{0};
    int taken = 0, seen = 0, calls = 0;

    Component() {
        prepareWaiting();
        add();
    }
    void add() {
        callbacks.set(port, [this](RTT::base::PortInterface*) {
            seen = sample.load(std::memory_order_relaxed);
            ++calls;
        });
    }
    void write(int value) {
        sample.store(value, std::memory_order_relaxed);
        announceAndQueue();
    }
    void announceAndQueue() {
        const std::uint64_t announcement = callbacks.announce(port, true);
        if (!announcement) return;
        queued.fetch_add(1, std::memory_order_release);
        callbacks.queued(port, announcement);
    }
    void step() {
        if (queued.load(std::memory_order_acquire) == taken) return;
        ++taken;
        callbacks.call(port, true);
    }
};

/** After the last callback the component has seen the last sample. */
void oneWriter(Trial& trial) {
    Component component;
    trial.thread([&] {
        component.write(1);
        component.write(2);
    });
    trial.thread([&] {
        component.step();
        component.step();
    });
    trial.go();
    while (component.queued.load() != component.taken) component.step();
    require(component.seen == 2, "the component was not told of the last sample");
    require(component.calls <= component.queued.load(), "called more often than it was queued");
}

/** The same with two; the component is told of the last samples of both. One that stops before it has queued the port leaves
    the other one's announcement alone. */
void twoWriters(Trial& trial) {
    Component component;
    std::atomic<int> other{0};
    int seenOther = 0;
    component.callbacks.set(component.port, [&](RTT::base::PortInterface*) {
        component.seen = component.sample.load(std::memory_order_relaxed);
        seenOther = other.load(std::memory_order_relaxed);
    });
    trial.thread([&] { component.write(1); });
    trial.thread([&] {
        other.store(1, std::memory_order_relaxed);
        component.announceAndQueue();
    });
    trial.thread([&] { component.step(); });
    trial.go();
    while (component.queued.load() != component.taken) component.step();
    require(component.seen == 1 && seenOther == 1, "the component was not told of the last samples");
}

/** A writer stops for ever before it has queued the port. */
void stoppedWriter(Trial& trial) {
    Component component;
    trial.thread([&] { component.callbacks.announce(component.port, true); });
    trial.thread([&] { component.write(2); });
    trial.go();
    while (component.queued.load() != component.taken) component.step();
    require(component.seen == 2, "the component was not told of the last sample");
}

/** The component removes its port and adds it again while somebody announces. */
void removing(Trial& trial) {
    Component component;
    trial.thread([&] { component.write(1); });
    trial.thread([&] {
        component.callbacks.remove(component.port);
        component.add();
    });
    trial.go();
    Reclaimer::collect();
    require(Reclaimer::pending() == 0, "tables are left");
    component.write(2);
    component.step();
    if (component.queued.load() != component.taken) component.step();
    require(component.seen == 2, "the component was not told of the last sample");
}

/** A port is removed by another thread: afterwards its callback is not executed any more. */
void removedWhileCalled(Trial& trial) {
    prepareWaiting();
    PortCallbacks callbacks;
    auto* const port = reinterpret_cast<RTT::base::PortInterface*>(&callbacks);
    model::Plain<int> data(0);  // what the callback uses
    callbacks.set(port, [&](RTT::base::PortInterface*) { data = data + 1; });
    callbacks.announce(port, true);
    trial.thread([&] { callbacks.call(port, true); });
    trial.thread([&] {
        callbacks.remove(port);
        data = 7;
    });
    trial.go();
    require(data == 7, "called after it was removed");
}

/** Two callbacks that remove each other's port do not wait for each other. */
void removingEachOther(Trial& trial) {
    prepareWaiting();
    std::array<PortCallbacks, 2> callbacks;
    const auto portOf = [&](std::size_t i) { return reinterpret_cast<RTT::base::PortInterface*>(&callbacks[i]); };
    std::array<std::unique_ptr<PortCallbacks::Execution>, 2> executions;
    for (std::size_t i = 0; i < 2; ++i) {
        callbacks[i].set(portOf(i), [](RTT::base::PortInterface*) {});
        executions[i] = std::make_unique<PortCallbacks::Execution>(callbacks[i], portOf(i));
        executions[i]->entry_->thread.store(static_cast<pthread_t>(i + 2));  // that of trial.thread()
    }
    for (std::size_t i = 0; i < 2; ++i)
        trial.thread([&, i] {
            callbacks[1 - i].remove(portOf(1 - i));
            executions[i].reset();
        });
    trial.go();
}

TEST(PortCallbacks, one_writer) { EXPECT_TRUE(model::holds(oneWriter)); }
TEST(PortCallbacks, two_writers) { EXPECT_TRUE(model::holds(twoWriters, {0})); }
TEST(PortCallbacks, a_writer_that_stopped) { EXPECT_TRUE(model::holds(stoppedWriter)); }
TEST(PortCallbacks, a_port_is_removed_while_it_is_announced) { EXPECT_TRUE(model::holds(removing)); }

TEST(PortCallbacks, a_port_is_removed_while_its_callback_runs) { EXPECT_TRUE(model::holds(removedWhileCalled)); }
TEST(PortCallbacks, callbacks_remove_each_others_ports) { EXPECT_TRUE(model::holds(removingEachOther, {0})); }

TEST(PortCallbacks, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("callbacks_relaxed_announcement", oneWriter));
    EXPECT_TRUE(model::catches("callbacks_cleared_late", oneWriter));
    EXPECT_TRUE(model::catches("callbacks_rely_on_an_announcement", stoppedWriter));
    EXPECT_TRUE(model::catches("callbacks_rounds_repeat", twoWriters, {0}));
    EXPECT_TRUE(model::catches("callbacks_deleted_at_once", removing));
    EXPECT_TRUE(model::catches("callbacks_relaxed_table", removing));
    EXPECT_TRUE(model::catches("callbacks_not_waited_for", removedWhileCalled));
    EXPECT_TRUE(model::catches("callbacks_removal_unseen", removedWhileCalled));
    EXPECT_TRUE(model::catches("callbacks_relaxed_end", removedWhileCalled));
    EXPECT_TRUE(model::catches("callbacks_end_unheard", removedWhileCalled));
    EXPECT_TRUE(model::catches("callbacks_wait_for_each_other", removingEachOther, {0}));
}

}  // namespace
