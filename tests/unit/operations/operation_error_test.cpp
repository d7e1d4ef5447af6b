// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What the caller of an operation, and the log, are told of what went wrong in the component's thread.
#include "../flow/log_capture.hpp"
#include "probe.hpp"

#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/OperationCallerC.hpp>

#include <stdexcept>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Probe;

namespace {

/** Says that it can be assigned, and cannot. */
struct Unassignable : internal::DataSource<int> {
    bool isAssignable() const override { return true; }
    int get() const override { return number; }
    int value() const override { return number; }
    const int& rvalue() const override { return number; }
    Unassignable* clone() const override { return new Unassignable(); }
    Unassignable* copy(std::map<const DataSourceBase*, DataSourceBase*>&) const override { return clone(); }
    int number = 0;
};

struct OperationError : testing::Test {
    Probe server{"server"};
    ExecutionEngine* global = internal::GlobalEngine::Instance();
    flow_test::LogCapture log;

    OperationError() {
        server.addOperation(
            "grasp", [](int) -> int { throw std::logic_error("no object in sight"); }, OwnThread);
        server.addOperation(
            "odd", [] { throw 42; }, OwnThread);
        server.addOperation("late", [] { throw std::logic_error("too late"); });
        server.addOperation(
            "wait", [] {}, OwnThread);
    }
    OperationInterfacePart* part(const char* name) { return server.getOperation(name); }

    template <class Action>
    static std::string textOf(Action action) {
        try {
            action();
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "nothing";
    }
    static void expectAll(const std::string& text, std::initializer_list<const char*> parts) {
        for (const char* each : parts) EXPECT_NE(text.find(each), std::string::npos) << each << " is not in: " << text;
    }
};

TEST_F(OperationError, TextNamesOperationComponentAndCauseInACall) {
    OperationCaller<int(int)> grasp(part("grasp"), global);
    expectAll(textOf([&] { grasp(1); }), {"'grasp'", "'server'", "no object in sight"});
    expectAll(textOf([&] { OperationCaller<void()>(part("odd"), global)(); }), {"'odd'", "'server'"});
}

TEST_F(OperationError, TextIsTheSameInCollectAndRet) {
    OperationCaller<int(int)> grasp(part("grasp"), global);
    auto handle = grasp.send(1);
    const std::string text = textOf([&] { handle.collect(); });
    expectAll(text, {"'grasp'", "'server'", "no object in sight"});
    int result = 0;
    EXPECT_EQ(textOf([&] { handle.collectIfDone(result); }), text);
    EXPECT_EQ(textOf([&] { handle.ret(); }), text);
}

TEST_F(OperationError, TextReachesGenericCallers) {
    internal::OperationCallerC grasp(part("grasp"), "grasp", global);
    grasp.argC(1);
    expectAll(textOf([&] { grasp.call(); }), {"'grasp'", "no object in sight"});
    expectAll(textOf([&] { grasp.send().collect(); }), {"'grasp'", "no object in sight"});
}

TEST_F(OperationError, WhatCannotBeAssignedIsNotCollected) {
    server.addOperation("twice", [](int n) { return 2 * n; });
    internal::OperationCallerC twice(part("twice"), "twice", global);
    internal::SendHandleC handle = twice.argC(2).send();
    EXPECT_EQ(handle.arg(base::DataSourceBase::shared_ptr(new Unassignable())).collect(), CollectFailure);
}

TEST_F(OperationError, WithoutCallerTheLogNamesOperationComponentAndCauseOnce) {
    OperationCaller<int(int)> grasp = part("grasp");
    grasp.send(1);
    ASSERT_TRUE(eventually([&] { return server.inException(); }));
    expectAll(log.text(), {"'grasp'", "'server'", "no object in sight"});
    const std::string text = log.text();
    EXPECT_EQ(text.find("no object"), text.rfind("no object")) << text;
}

TEST_F(OperationError, OfAClientThreadOperationThatWasSentNamesTheGlobalEngine) {
    OperationCaller<void()> late(part("late"), global);
    expectAll(textOf([&] { late.send().collect(); }), {"'late'", "GlobalEngine", "too late"});
    EXPECT_FALSE(server.inException());
}

TEST_F(OperationError, RefusedCallsNameTheOperation) {
    expectAll(textOf([&] { OperationCaller<void()>(part("wait"))(); }), {"'wait'", "without a caller"});
    server.fatal();
    expectAll(textOf([&] { OperationCaller<void()>(part("wait"), global)(); }), {"'wait'", "'server'", "FatalError"});
}

TEST_F(OperationError, ConnectingServicesNamesWhatIsMissing) {
    Probe client("client");
    OperationCaller<void()> wait("wait"), open("open"), close("close");
    for (auto* each : {&wait, &open, &close}) client.requires_("gripper")->addOperationCaller(*each);
    server.provides("gripper")->addOperation("wait", [] {});
    EXPECT_FALSE(client.connectServices(&server));
    EXPECT_TRUE(wait.ready()) << "what is there is connected";
    expectAll(log.text(), {"'gripper'", "server", "client", "close, open"});
}

TEST_F(OperationError, ServicesAreConnectedInBothDirections) {
    Probe client("client");
    OperationCaller<void()> wait("wait"), open("open"), root("wait");
    client.requires_("gripper")->addOperationCaller(wait);
    client.requires_()->addOperationCaller(root);
    server.requires_("door")->addOperationCaller(open);
    server.provides("gripper")->addOperation("wait", [] {});
    client.provides("door")->addOperation("open", [] {});
    EXPECT_TRUE(server.connectServices(&client));
    EXPECT_TRUE(wait.ready() && open.ready() && root.ready());
    EXPECT_EQ(log.text(), "");
}

TEST_F(OperationError, NameIsThatOfTheOperationWhoseFunctionWasReset) {
    Operation<int(int)> other(
        "other", [](int) -> int { throw std::runtime_error("still none"); }, OwnThread);
    ASSERT_TRUE(server.provides()->resetOperation("grasp", &other));
    expectAll(textOf([&] { OperationCaller<int(int)>(part("grasp"), global)(1); }), {"'grasp'", "still none"});
}

}  // namespace
