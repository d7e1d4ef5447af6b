// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/GlobalEngine.hpp>

#include <rtt/Activity.hpp>
#include <rtt/ExecutionEngine.hpp>
#include <rtt/internal/engine/other_order.hpp>
#include <rtt/os/StartStopManager.hpp>

#include <atomic>
#include <memory>
#include <mutex>

namespace RTT::internal {

namespace {

enum State { Off, On, Releasing };

struct Global {
    ExecutionEngine engine;
    std::mutex mutex;
    base::ActivityInterface::shared_ptr activity;
    std::atomic<State> state{Off};
};

// The engine is never destroyed: other threads may send while its thread ends, and later.
Global& global() {
    static Global* const one = new Global;
    return *one;
}

// __os_exit() ends the thread before it destroys what the thread may use.
const os::CleanupFunction releaseAtExit(&GlobalEngine::Release, os::StopEngines);

}  // namespace

ExecutionEngine* GlobalEngine::Instance() {
    Global& g = global();
    // Acquire: pairs with the store below, so that the activity is complete. Sending must not lock, and the thread that
    // is ending must not start another one.
    if (g.state.load(std::memory_order_acquire) != Off) return &g.engine;
    std::lock_guard<std::mutex> lock(g.mutex);
    if (g.state == Off) {
        // It gets the engine once complete: a thread that got the engine before the last Release() may be sending now.
        Activity::Options options;
        options.name = "GlobalEngine";
        if (OtherOrder* const order = OtherOrder::installed())
            g.activity = order->replace(nullptr, options.name);
        else
            g.activity.reset(new Activity(options));
        g.activity->run(&g.engine);
        g.activity->start();
        g.state.store(On, std::memory_order_release);
    }
    return &g.engine;
}

void GlobalEngine::Release() {
    Global& g = global();
    if (g.engine.isStepping()) return;
    base::ActivityInterface::shared_ptr last;
    {
        std::lock_guard<std::mutex> lock(g.mutex);
        if (g.state != On) return;
        g.state = Releasing;
        last.swap(g.activity);
    }
    // Without the lock: the thread may be executing code that calls Instance().
    last->stop();
    g.engine.setActivity(nullptr);  // waits for threads that are triggering it
    last.reset();
    g.engine.setFatalTask();  // disposes of messages that are no longer executed
    g.state = Off;
}

}  // namespace RTT::internal
