// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How an input port tells its component of new samples while the port or the component goes away.
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>

#define pthread_key_create(key, destructor) static_cast<void>(0)
#define pthread_setspecific(key, value) static_cast<void>(0)
#include <rtt/base/input_port_signals.cpp>
#include <rtt/internal/Reclaimer.cpp>

namespace {

using model::require;
using model::Trial;
using RTT::DataFlowInterface;
using RTT::base::InputPortInterface;
using RTT::internal::Reclaimer;
using RTT::internal::ReclaimerState;

struct World {
    DataFlowInterface* component = new DataFlowInterface;
    InputPortInterface* port = new InputPortInterface;
    std::atomic<InputPortInterface*> input{port};  // the endpoint's pointer

    World() {
        model::threadLocal(&Reclaimer::record_, sizeof Reclaimer::record_);
        model::threadLocal(&RTT::base::deliveries, sizeof RTT::base::deliveries);
        new (&ReclaimerState::instance()) ReclaimerState;
        port->setInterface(component);
        port->signalInterface(true);
    }
    /** As a channel does, see internal::PortEndpoint::signal(). */
    void write() {
        const Reclaimer::Guard guard;
        if (InputPortInterface* const seen = input.load(std::memory_order_acquire)) seen->signalLater();
    }
};

/** As base::PortInterface::closeDown() does. */
void portDestroyed(Trial& trial) {
    World world;
    trial.thread([&] { world.write(); });
    trial.thread([&] {
        world.port->setInterface(nullptr);
        world.port->finishSignals();
        world.input.store(nullptr, std::memory_order_release);
        Reclaimer::synchronize();
        delete world.port;
    });
    trial.go();
    require(world.component->told <= 1, "told twice");
}

/** As DataFlowInterface::takeOut() does: the component goes, the port stays. */
void componentDestroyed(Trial& trial) {
    World world;
    trial.thread([&] { world.write(); });
    trial.thread([&] {
        world.port->setInterface(nullptr);
        world.port->finishSignals();
        delete world.component;
    });
    trial.go();
}

TEST(PortSignals, the_port_is_destroyed) { EXPECT_TRUE(model::holds(portDestroyed)); }
TEST(PortSignals, the_component_is_destroyed) { EXPECT_TRUE(model::holds(componentDestroyed)); }

TEST(PortSignals, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("signals_relaxed_pin", componentDestroyed));
    EXPECT_TRUE(model::catches("signals_relaxed_end", portDestroyed));
    EXPECT_TRUE(model::catches("signals_not_waited_for", componentDestroyed));
}

}  // namespace
