// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How an input port tells its component of new samples while the port or the component goes away.
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>
#include <model/checked_waiting.hpp>

#include <rtt/base/input_port_signals.cpp>

namespace {

using model::prepareWaiting;
using model::require;
using model::Trial;
using RTT::DataFlowInterface;
using RTT::base::InputPortInterface;
using RTT::internal::Reclaimer;

/** A port of a component. */
struct World {
    DataFlowInterface* component = new DataFlowInterface;
    InputPortInterface* port = new InputPortInterface;
    std::atomic<InputPortInterface*> input{port};  // the endpoint's pointer

    World() {
        port->setInterface(component);
        port->signalInterface(true);
    }
    /** As a channel does, see internal::PortEndpoint::signal(). */
    void write() {
        const Reclaimer::Guard guard;
        if (InputPortInterface* const seen = input.load(std::memory_order_acquire)) seen->signalLater();
    }
    /** As base::PortInterface::closeDown() does. */
    void destroyPort() {
        port->setInterface(nullptr);
        port->finishSignals();
        input.store(nullptr, std::memory_order_release);
        Reclaimer::synchronize();
        delete port;
    }
};

void portDestroyed(Trial& trial) {
    prepareWaiting();
    World world;
    trial.thread([&] { world.write(); });
    trial.thread([&] { world.destroyPort(); });
    trial.go();
    require(world.component->told <= 1, "told twice");
}

/** As DataFlowInterface::takeOut() does: the component goes, the port stays. */
void componentDestroyed(Trial& trial) {
    prepareWaiting();
    World world;
    trial.thread([&] { world.write(); });
    trial.thread([&] {
        world.port->setInterface(nullptr);
        world.port->finishSignals();
        delete world.component;
    });
    trial.go();
}

/** One write signals two ports; in the callback of the first the second one is destroyed. Another thread tells it, too. */
void siblingDestroyed(Trial& trial) {
    prepareWaiting();
    World first, second;
    first.component->onData = [&](InputPortInterface*) { second.destroyPort(); };
    trial.thread([&] {
        const Reclaimer::Guard guard;
        first.write();
        second.write();
    });
    trial.thread([&] { second.write(); });
    trial.go();
    require(second.component->told <= 1, "told of by who destroyed it");
}

/** The callbacks of two ports, in two threads, end each other's ports. */
void endingEachOther(Trial& trial) {
    prepareWaiting();
    World told[2];
    for (int i = 0; i != 2; ++i) {
        told[i].component->onData = [&, i](InputPortInterface*) { told[1 - i].port->finishSignals(); };
        trial.thread([&, i] { told[i].write(); });
    }
    trial.go();
    for (World& world : told) require(world.port->pinned_.load() == 0, "a signal was ended twice, or not at all");
}

/** A thread waits for something that another one does after it has ended a port. The thread is telling that port's
    component, or has yet to do so. */
template <bool telling>
void owingWhileWaiting(Trial& trial) {
    prepareWaiting();
    World world;
    std::atomic<std::uint32_t> ended{0};
    const auto wait = [&](InputPortInterface*) {
        const model::Waiting here;
        while (ended == 0) model::futexWait(ended, 0);
    };
    if (telling) world.component->onData = wait;
    trial.thread([&] {
        const Reclaimer::Guard guard;
        world.write();
        if (!telling) wait(world.port);
    });
    trial.thread([&] {
        world.port->setInterface(nullptr);
        world.port->finishSignals();
        ended = 1;
        model::futexWake(ended, 1);
    });
    trial.go();
    require(world.port->pinned_.load() == 0, "a signal was ended twice, or not at all");
}

/** More signals than there are places for: after the last one the component has seen all samples. */
void manySignals(Trial& trial) {
    prepareWaiting();
    World world;
    std::atomic<int> sample[2] = {{0}, {0}};
    std::atomic<int> seen[2] = {{0}, {0}};
    world.component->onData = [&](InputPortInterface*) {
        for (int i = 0; i != 2; ++i)
            if (sample[i].load(std::memory_order_relaxed)) seen[i].store(1, std::memory_order_relaxed);
    };
    trial.thread([&] {
        sample[0].store(1, std::memory_order_relaxed);
        world.write();
    });
    trial.thread([&] {
        // Uses up the places of this thread.
        RTT::internal::DeferredCalls& calls = Reclaimer::deferred();
        const Reclaimer::Guard guard;
        for (std::uint32_t n = RTT::internal::DeferredCalls::kSpare; n != 0; --n)
            calls.add(
                nullptr, [](void*&) {}, &world);
        sample[1].store(1, std::memory_order_relaxed);
        world.write();
    });
    trial.go();
    require(seen[0] && seen[1], "the component was not told of a sample");
    require((world.port->pinned_.load() & ~InputPortInterface::kAgain) == 0, "the port is pinned for ever");
}

TEST(PortSignals, the_port_is_destroyed) { EXPECT_TRUE(model::holds(portDestroyed)); }
TEST(PortSignals, the_component_is_destroyed) { EXPECT_TRUE(model::holds(componentDestroyed)); }

TEST(PortSignals, a_port_is_destroyed_in_the_callback_of_another) { EXPECT_TRUE(model::holds(siblingDestroyed)); }
TEST(PortSignals, two_callbacks_end_each_others_ports) { EXPECT_TRUE(model::holds(endingEachOther, {0})); }
TEST(PortSignals, a_thread_that_waits_owes_a_signal) {
    EXPECT_TRUE(model::holds(owingWhileWaiting<true>));
    EXPECT_TRUE(model::holds(owingWhileWaiting<false>));
}
TEST(PortSignals, more_signals_than_places) { EXPECT_TRUE(model::holds(manySignals)); }

TEST(PortSignals, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("signals_relaxed_pin", componentDestroyed));
    EXPECT_TRUE(model::catches("signals_relaxed_end", portDestroyed));
    EXPECT_TRUE(model::catches("signals_not_waited_for", componentDestroyed));
    EXPECT_TRUE(model::catches("signals_not_cancelled", siblingDestroyed));
    EXPECT_TRUE(model::catches("signals_wait_for_each_other", endingEachOther, {0}));
    EXPECT_TRUE(model::catches("signals_wait_for_each_other", owingWhileWaiting<false>));
    EXPECT_TRUE(model::catches("signals_not_taken_over_while_made", owingWhileWaiting<true>));
    EXPECT_TRUE(model::catches("signals_end_unheard", componentDestroyed));
    EXPECT_TRUE(model::catches("signals_waiting_unheard", owingWhileWaiting<false>));
    EXPECT_TRUE(model::catches("signals_place_used_twice", manySignals));
    EXPECT_TRUE(model::catches("signals_owed_and_forgotten", manySignals));
    EXPECT_TRUE(model::catches("signals_relaxed_debt", manySignals));
}

}  // namespace
