// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// SentCall, EngineGate and the queue side of ExecutionEngine, with the real mailbox, wait point and pool of calls.
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>
#include <model/checked_presence.hpp>

#include <rtt/os/fosi.h>
// Time stands still: what only happens after a while does not happen.
#define rtos_get_time_ns() NANO_TIME(0)
#include <rtt/ExecutionEngine.cpp>
#include <rtt/engine_queue.cpp>
#include <rtt/internal/calls/call_pool.cpp>
#include <rtt/internal/engine/detail/guarded_call.cpp>
#include <rtt/internal/engine/engine_functions.cpp>
#include <rtt/internal/engine/engine_gate.cpp>
#include <rtt/internal/engine/function_list.cpp>
#include <rtt/internal/engine/mailbox.cpp>
#include <rtt/internal/calls/sent_call.cpp>
#include <rtt/internal/engine/wait_point.cpp>
#include <rtt/base/DisposableInterface.cpp>
#include <rtt/base/RunnableInterface.cpp>

RTT::ExecutionEngine* RTT::internal::GlobalEngine::Instance() { return nullptr; }
// A thread that calls in the executor's name asks for it.
RTT::os::ThreadInterface* RTT::os::MainThread::Instance() { return nullptr; }
void RTT::internal::CalleeBase::deref() const {}  // there are none
std::string RTT::internal::describe(const CalleeBase*) { return {}; }

namespace {

using model::require;
using model::Trial;
using RTT::ExecutionEngine;
using RTT::base::ActivityInterface;
using RTT::base::TaskCore;
using RTT::internal::EngineGate;
using RTT::internal::SentCall;

void prepare() {
    model::preparePresence();
    model::threadLocal(&EngineGate::Step::innermost_, sizeof EngineGate::Step::innermost_);
}

/** A call that says what became of it. */
struct Call : SentCall {
    explicit Call(std::atomic<int>& count) : SentCall(nullptr), freed(count) {}
    ~Call() override { freed.fetch_add(1, std::memory_order_relaxed); }
    void run() override { result = 42; }
    const void* resultAddress() const override { return &result; }
    void* argumentAddress(unsigned) override { return nullptr; }
    model::Plain<int> result{0};
    std::atomic<int>& freed;
};

/** A message on the stack. */
struct Message : RTT::base::DisposableInterface {
    void executeAndDispose() override { ended.fetch_add(1); }
    void dispose() override { ended.fetch_add(1); }
    bool isError() const override { return false; }
    std::atomic<int> ended{0};
};

/** A thread that is no component calls an operation of a component and collects the result. */
void calling(Trial& trial) {
    prepare();
    ExecutionEngine caller, engine;
    ActivityInterface activity(&engine);
    std::atomic<int> freed{0};
    trial.thread([&] { activity.loop(); });
    trial.thread([&] {
        const SentCall::shared_ptr call(new Call(freed));
        call->setEngines(&caller, &engine);
        call->ref();
        require(ExecutionEngine::process(*engine.gate(), call.get()), "refused");
        require(call->collect() == RTT::SendSuccess, "not executed");
        require(static_cast<Call&>(*call).result == 42, "no result");
        activity.end();
    });
    trial.go();
    require(freed == 1, "not freed, or twice");
}

/** The caller lets go of its handle without waiting. */
void sending(Trial& trial) {
    prepare();
    ExecutionEngine caller, engine;
    ActivityInterface activity(&engine);
    std::atomic<int> freed{0};
    trial.thread([&] { engine.work(ExecutionEngine::Trigger); });
    trial.thread([&] {
        const SentCall::shared_ptr call(new Call(freed));
        call->setEngines(&caller, &engine);
        call->ref();
        require(ExecutionEngine::process(*engine.gate(), call.get()), "refused");
        if (call->status() == RTT::SendSuccess) require(static_cast<Call&>(*call).result == 42, "no result");
    });
    trial.go();
    engine.work(ExecutionEngine::Trigger);
    require(freed == 1, "not freed, or twice");
}

/** The component enters FatalError while somebody sends: the message is refused, executed or disposed of. */
void fatal(Trial& trial) {
    prepare();
    TaskCore task;
    ExecutionEngine engine(&task);
    ActivityInterface activity(&engine);
    Message message;
    bool accepted = false;
    trial.thread([&] {
        task.fatal.store(true);
        engine.setFatalTask();
    });
    trial.thread([&] { accepted = engine.process(&message); });
    trial.go();
    require(message.ended == (accepted ? 1 : 0), "a message is forgotten, or ended twice");
}

/** A component waits for something that a message to it brings. */
void waiting(Trial& trial) {
    prepare();
    ExecutionEngine engine;
    ActivityInterface activity(&engine);
    Message message;
    trial.thread([&] {
        activity.executor.store(model::self(), std::memory_order_relaxed);
        engine.waitForMessages([&] { return message.ended.load() != 0; });
    });
    trial.thread([&] { require(engine.process(&message), "refused"); });
    trial.go();
}

/** The engine is destroyed while somebody sends to it. */
void destroying(Trial& trial) {
    prepare();
    auto* const engine = new ExecutionEngine;
    auto* const activity = new ActivityInterface(engine);
    const boost::intrusive_ptr<const EngineGate> gate = engine->gate();
    Message message;
    bool accepted = false;
    trial.thread([&] {
        delete engine;
        delete activity;
    });
    trial.thread([&] { accepted = ExecutionEngine::process(*gate, &message); });
    trial.go();
    require(message.ended == (accepted ? 1 : 0), "a message is forgotten, or ended twice");
}

/** A thread retires the engine and goes on to destroy what calls touch that another engine executes. */
void retiring(Trial& trial) {
    prepare();
    ExecutionEngine engine;
    ActivityInterface activity(&engine);
    const boost::intrusive_ptr<const EngineGate> gate = engine.gate();
    std::atomic<int> freed{0};
    model::Plain<int> member{0};
    struct Touching : Call {
        Touching(std::atomic<int>& count, model::Plain<int>& place) : Call(count), touched(place) {}
        void run() override { touched = 1; }
        model::Plain<int>& touched;
    };
    Message message;
    bool accepted = false;
    trial.thread([&] {
        engine.retire();
        member = 2;
    });
    trial.thread([&] {
        const SentCall::shared_ptr call(new Touching(freed, member));
        call->setProvider(gate, false);
        call->ref();
        call->executeAndDispose();
        accepted = ExecutionEngine::process(*gate, &message);
    });
    trial.go();
    require(message.ended == (accepted ? 1 : 0), "a message is forgotten, or ended twice");
}

/** A thread that stops the activity within its own step: who sees that it is stopped waits for the end of the step. */
void lastStep(Trial& trial) {
    prepare();
    ExecutionEngine engine;
    std::atomic<bool> active{true};
    model::Plain<int> touched{0};
    trial.thread([&] {
        const EngineGate::Step here(*engine.gate());
        active.store(false);
        touched = 1;
    });
    trial.thread([&] {
        if (active.load()) return;
        engine.gate()->waitForStep();
        touched = 2;
    });
    trial.go();
}

/** Somebody sends while the activity is being started: the message is executed. */
void starting(Trial& trial) {
    prepare();
    ExecutionEngine engine;
    ActivityInterface activity(&engine);
    activity.active.store(false);
    struct Last : Message {
        explicit Last(ActivityInterface& a) : activity(a) {}
        void executeAndDispose() override {
            Message::executeAndDispose();
            activity.end();
        }
        ActivityInterface& activity;
    } message(activity);
    trial.thread([&] { activity.loop(); });
    trial.thread([&] { require(engine.startActivity(), "not started"); });
    trial.thread([&] { require(engine.process(&message), "refused"); });
    trial.go();
    require(message.ended == 1, "not executed, or twice");
}

TEST(Engine, sending_while_the_activity_starts) { EXPECT_TRUE(model::holds(starting)); }
TEST(Engine, a_call_is_collected) { EXPECT_TRUE(model::holds(calling)); }
TEST(Engine, a_call_is_sent_and_forgotten) { EXPECT_TRUE(model::holds(sending)); }
TEST(Engine, sending_to_a_component_that_fails) { EXPECT_TRUE(model::holds(fatal)); }
TEST(Engine, a_waiting_component_executes_messages) { EXPECT_TRUE(model::holds(waiting)); }
TEST(Engine, sending_to_a_component_that_is_destroyed) { EXPECT_TRUE(model::holds(destroying)); }
TEST(Engine, sending_to_a_component_that_is_retired) { EXPECT_TRUE(model::holds(retiring)); }
TEST(Engine, the_last_step_is_waited_for) { EXPECT_TRUE(model::holds(lastStep)); }

TEST(Engine, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("call_relaxed_state", calling));
    EXPECT_TRUE(model::catches("call_sleeps_for_ever", calling));
    EXPECT_TRUE(model::catches("call_relaxed_deref", sending));
    EXPECT_TRUE(model::catches("engine_state_not_asked_again", fatal));
    EXPECT_TRUE(model::catches("engine_not_notified", waiting));
    EXPECT_TRUE(model::catches("engine_start_not_marked", starting));
    EXPECT_TRUE(model::catches("engine_start_forgets", starting));
    EXPECT_TRUE(model::catches("gate_visitors_ignored", destroying));
    EXPECT_TRUE(model::catches("gate_closed_late", destroying));
    EXPECT_TRUE(model::catches("gate_retired_late", retiring));
    EXPECT_TRUE(model::catches("gate_visitors_ignored", retiring));
    EXPECT_TRUE(model::catches("engine_retired_not_asked_again", retiring));
    EXPECT_TRUE(model::catches("gate_visitors_ignored", lastStep));
}

}  // namespace
