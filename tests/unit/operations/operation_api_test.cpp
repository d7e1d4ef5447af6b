// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Less used ways to provide an operation, to get hold of one and to be told of its calls.
#include "probe.hpp"

#include <rtt/FactoryExceptions.hpp>
#include <rtt/Operation.hpp>
#include <rtt/base/ActionInterface.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <boost/make_shared.hpp>

using namespace RTT;
using namespace RTT::internal;
using oroforge::test::eventually;
using oroforge::test::Probe;

namespace {

TEST(Implementation, IsHeldAsAMessageByOlderCode) {
    Probe c;
    c.addOperation("op", [](int n) { return n + 1; });
    base::DisposableInterface::shared_ptr held = c.provides()->getLocalOperation("op");
    ASSERT_TRUE(held);
    held->dispose();  // it is none, so nothing happens
    OperationCaller<int(int)> constructed(held, c.engine()), assigned("op"), set("op");
    assigned = held;
    EXPECT_TRUE(set.setImplementation(held, c.engine()));
    EXPECT_EQ(constructed(1), 2);
    EXPECT_EQ(assigned(1), 2);
    EXPECT_EQ(set(1), 2);
    OperationCaller<int(int)> typed(c.provides()->getLocalOperation("op"));
    EXPECT_EQ(typed(1), 2);
}

TEST(Implementation, IsTakenFromAnyKindOfPointer) {
    Operation<int(int)> op("op", [](int n) { return n + 1; });
    Probe c;
    c.addOperation(op);
    const auto local = op.getOperationCaller();
    const base::OperationCallerBase<int(int)>::shared_ptr typed = local;
    const std::shared_ptr<base::DisposableInterface> standard(local.get(), [local](base::DisposableInterface*) {});
    OperationCaller<int(int)> a(local), b = typed, d(standard, c.engine()), e(op.getImplementation()),
                                        f("op", c.provides());
    OperationCaller<int(int)> g("op"), h("op"), i("op"), k("op", c.engine());
    g = local;
    h = standard;
    i = c.provides();
    k = c.getOperation("op");
    for (const OperationCaller<int(int)>& each : {a, b, d, e, f, g, h, i, k}) {
        EXPECT_TRUE(each.ready());
        EXPECT_EQ(each(1), 2);
    }
    EXPECT_EQ(a.getOperationCallerImpl()->call(4), 5);
}

TEST(Implementation, MayBeAFunctionThatNobodyRegistered) {
    struct Adder {
        int base;
        int add(int n) const { return base + n; }
    } adder{10};
    OperationCaller<int(int)> free("free", [](int n) { return n + 1; }), member("member", &Adder::add, &adder);
    EXPECT_EQ(free.getName(), "free");
    EXPECT_EQ(free(1), 2);
    EXPECT_EQ(member(1), 11);
    Probe c;
    OperationCaller<bool()> own(
        "own", [&c] { return c.engine()->isStepping(); }, c.engine(), GlobalEngine::Instance(), OwnThread);
    EXPECT_TRUE(own());
    EXPECT_FALSE((OperationCaller<int(int)>("none", boost::function<int(int)>()).ready()));
    EXPECT_FALSE((OperationCaller<int(int)>("none", nullptr).ready())) << "no engine";
}

TEST(Implementation, OfAnotherKindIsRefused) {
    struct Message : base::DisposableInterface {
        void executeAndDispose() override {}
        void dispose() override {}
    };
    OperationCaller<int(int)> op("op");
    EXPECT_FALSE(op.setImplementation(boost::make_shared<Message>()));
    EXPECT_FALSE(op.setImplementation(base::DisposableInterface::shared_ptr()));
    EXPECT_FALSE(op.ready());
}

struct NoDefault {
    explicit NoDefault(int n) : number(n) {}
    int number;
};

TEST(Caller, ResultsNeedNoDefaultValue) {
    Probe c;
    c.addOperation("make", [](int n) { return NoDefault(n); });
    OperationCaller<NoDefault(int)> make;
    EXPECT_THROW(make(1), std::logic_error) << "there is no value to stand for none";
    make = c.getOperation("make");
    EXPECT_EQ(make(4).number, 4);
}

struct Counter {
    int count = 0;
    int add(int n) { return count += n; }
    int peek() const { return count; }
};

TEST(LateObject, IsLookedUpWithEachCall) {
    Probe c;
    ValueDataSource<boost::shared_ptr<Counter>>::shared_ptr object(new ValueDataSource<boost::shared_ptr<Counter>>());
    c.provides()->addOperationDS("add", &Counter::add, object.get()).doc("adds").arg("n", "a number");
    c.provides()->addOperationDS("peek", &Counter::peek, object, OwnThread);
    OperationCaller<int(int)> add = c.getOperation("add");
    OperationCaller<int()> peek(c.getOperation("peek"), GlobalEngine::Instance());
    EXPECT_THROW(add(1), std::runtime_error) << "there is no object yet";

    const auto first = boost::make_shared<Counter>(), second = boost::make_shared<Counter>();
    object->set(first);
    EXPECT_EQ(add(1), 1);
    EXPECT_EQ(peek(), 1);
    object->set(second);
    EXPECT_EQ(add(5), 5);
    EXPECT_EQ(first->count, 1);
    EXPECT_EQ(second->count, 5);
}

struct Reset : testing::Test {
    Probe c;
    Operation<int(int)> twice{"twice", [](int n) { return 2 * n; }};
    Reset() {
        c.addOperation("op", [](int n) { return n; }).doc("documented").arg("n", "a number");
    }
};

TEST_F(Reset, GivesTheOperationAnotherFunction) {
    OperationCaller<int(int)> before = c.getOperation("op");
    ASSERT_TRUE(c.provides()->resetOperation("op", &twice));
    OperationCaller<int(int)> after = c.getOperation("op");
    EXPECT_EQ(before(3), 3) << "a caller keeps what it was bound to";
    EXPECT_EQ(after(3), 6);
    EXPECT_EQ(c.getOperation("op")->getName(), "op");
    EXPECT_EQ(c.getOperation("op")->description(), "documented");
    EXPECT_EQ(c.getOperation("op")->getArgumentList().at(0).name, "n");
    EXPECT_FALSE(c.provides()->hasOperation("twice"));
}

TEST_F(Reset, KeepsListenersAndThread) {
    int heard = 0;
    Handle handle = c.addEventOperation("event", [](int n) { return n; }).signals([&](int n) { heard = n; });
    ASSERT_TRUE(c.provides()->resetOperation("event", &twice));
    OperationCaller<int(int)> call = c.getOperation("event");
    EXPECT_EQ(call(3), 6);
    EXPECT_EQ(heard, 3);

    Operation<int(int)> own(
        "own", [this](int) { return c.engine()->isStepping() ? 1 : 0; }, OwnThread);
    ASSERT_TRUE(c.provides()->resetOperation("op", &own));
    EXPECT_EQ(OperationCaller<int(int)>(c.getOperation("op"), GlobalEngine::Instance())(0), 1)
        << "executed by the component it was added to";
}

TEST_F(Reset, RefusesWhatDoesNotFit) {
    Operation<int(double)> other("other", [](double) { return 1; });
    Operation<int(int)> unbound("unbound");
    EXPECT_FALSE(c.provides()->resetOperation("op", &other));
    EXPECT_FALSE(c.provides()->resetOperation("op", &unbound));
    EXPECT_FALSE(c.provides()->resetOperation("op", nullptr));
    EXPECT_FALSE(c.provides()->resetOperation("missing", &twice));
    EXPECT_EQ(OperationCaller<int(int)>(c.getOperation("op"))(3), 3);
}

/** Does what the test says. */
struct TestAction : base::ActionInterface {
    explicit TestAction(std::function<void()> f) : onExecute(std::move(f)) {}
    ~TestAction() override {
        if (onDestroy) onDestroy();
    }
    std::function<void()> onExecute, onDestroy;
    void readArguments() override {}
    bool execute() override { return onExecute(), true; }
    base::ActionInterface* clone() const override { return new TestAction(onExecute); }
};

struct ProduceSignal : testing::Test {
    Probe c{"server"};
    ValueDataSource<int>::shared_ptr number{new ValueDataSource<int>(0)};
    std::string order;
    ProduceSignal() {
        c.addEventOperation("event", [this](int n) { return order += "op ", n; });
        c.addOperation("plain", [](int) {});
    }
};

TEST_F(ProduceSignal, ExecutesTheActionWithTheArgumentsBeforeTheOperation) {
    int seen = 0;
    Handle handle = c.operations()->produceSignal(
        "event", new TestAction([&] { order += "action ", seen = number->get(); }), {number}, nullptr);
    ASSERT_TRUE(handle.connected());
    OperationCaller<int(int)> event = c.getOperation("event");
    EXPECT_EQ(event(5), 5);
    EXPECT_EQ(seen, 5);
    EXPECT_EQ(order, "action op ");
    handle.disconnect();
    event(6);
    EXPECT_EQ(seen, 5);
    EXPECT_TRUE(handle.connect());
    event(7);
    EXPECT_EQ(seen, 7);
}

TEST_F(ProduceSignal, ArgumentsAreAssignedWithoutAnActionToo) {
    Handle handle = c.getOperation("event")->produceSignal(nullptr, {number}, nullptr);
    OperationCaller<int(int)>(c.getOperation("event"))(5);
    EXPECT_EQ(number->get(), 5);
}

TEST_F(ProduceSignal, RefusesWhatDoesNotFit) {
    const OperationInterfacePart& event = *c.getOperation("event");
    EXPECT_THROW(event.produceSignal(nullptr, {}, nullptr), wrong_number_of_args_exception);
    EXPECT_THROW(event.produceSignal(nullptr, {new ValueDataSource<double>()}, nullptr), wrong_types_of_args_exception);
    EXPECT_THROW(event.produceSignal(nullptr, {nullptr}, nullptr), wrong_types_of_args_exception);
    EXPECT_THROW(event.produceSignal(nullptr, {new ConstantDataSource<int>(1)}, nullptr), non_lvalue_args_exception);
    EXPECT_THROW(c.getOperation("plain")->produceSignal(nullptr, {number}, nullptr),
                 no_asynchronous_operation_exception);
    EXPECT_THROW(c.operations()->produceSignal("missing", nullptr, {}, nullptr), name_not_found_exception);
}

TEST_F(ProduceSignal, ConnectionOwnsTheAction) {
    bool destroyed = false;
    auto* action = new TestAction([] {});
    action->onDestroy = [&] { destroyed = true; };
    {
        CleanupHandle handle(c.getOperation("event")->produceSignal(action, {number}, nullptr));
        EXPECT_FALSE(destroyed);
    }
    EXPECT_TRUE(destroyed);
}

TEST_F(ProduceSignal, ActionIsExecutedByItsSubscriber) {
    Probe subscriber{"subscriber"};
    std::atomic<int> seen{0}, wrong{0};
    c.addEventOperation("bare", [] {});
    Handle handle = c.getOperation("bare")->produceSignal(new TestAction([&] {
                                                              if (!subscriber.engine()->isStepping()) ++wrong;
                                                              ++seen;
                                                          }),
                                                          {}, subscriber.engine());
    OperationCaller<void()> bare = c.getOperation("bare");
    for (int i = 0; i != 20; ++i) bare();
    EXPECT_TRUE(eventually([&] { return seen == 20; }));
    EXPECT_EQ(wrong, 0);
    handle.disconnect();
    bare();
    EXPECT_EQ(seen, 20);
}

TEST_F(ProduceSignal, SubscriberMayBeGone) {
    std::atomic<int> seen{0};
    c.addEventOperation("bare", [] {});
    Handle handle;
    {
        Probe subscriber{"subscriber"};
        handle = c.getOperation("bare")->produceSignal(new TestAction([&] { ++seen; }), {}, subscriber.engine());
    }
    OperationCaller<void()>(c.getOperation("bare"))();
    EXPECT_EQ(seen, 0);
}

}  // namespace
