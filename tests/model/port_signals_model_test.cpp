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

/** In the callback of each of two ports, in two threads, the other one is taken out of its component. `pending`: one that
    the other thread has yet to tell. */
template <bool pending>
void endingEachOther(Trial& trial) {
    prepareWaiting();
    World told[2], waiting[2];
    for (int i = 0; i != 2; ++i)
        told[i].component->onData = [&, i](InputPortInterface*) {
            World& other = (pending ? waiting : told)[1 - i];
            other.port->setInterface(nullptr);
            other.port->finishSignals();
        };
    for (int i = 0; i != 2; ++i)
        trial.thread([&, i] {
            const Reclaimer::Guard guard;
            told[i].write();
            if (pending) waiting[i].write();
        });
    trial.go();
    for (World* const world : {&told[0], &told[1], &waiting[0], &waiting[1]})
        require(world->port->pinned_.load() == 0, "a signal was ended twice, or not at all");
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
TEST(PortSignals, two_callbacks_end_each_others_ports) {
    EXPECT_TRUE(model::holds(endingEachOther<false>, {0}));
    EXPECT_TRUE(model::holds(endingEachOther<true>, {0}));
}
TEST(PortSignals, more_signals_than_places) { EXPECT_TRUE(model::holds(manySignals)); }

TEST(PortSignals, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("signals_relaxed_pin", componentDestroyed));
    EXPECT_TRUE(model::catches("signals_relaxed_end", portDestroyed));
    EXPECT_TRUE(model::catches("signals_not_waited_for", componentDestroyed));
    EXPECT_TRUE(model::catches("signals_not_cancelled", siblingDestroyed));
    EXPECT_TRUE(model::catches("signals_wait_for_each_other", endingEachOther<false>, {0}));
    EXPECT_TRUE(model::catches("signals_wait_for_each_other", endingEachOther<true>, {0}));
    EXPECT_TRUE(model::catches("signals_not_taken_over_while_made", endingEachOther<false>, {0}));
    EXPECT_TRUE(model::catches("signals_place_used_twice", manySignals));
    EXPECT_TRUE(model::catches("signals_owed_and_forgotten", manySignals));
    EXPECT_TRUE(model::catches("signals_relaxed_debt", manySignals));
}

}  // namespace
