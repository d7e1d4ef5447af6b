// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Providing operations and calling them by name, in the thread of the caller.
#include "probe.hpp"

#include <rtt/Operation.hpp>

#include <boost/bind/bind.hpp>
#include <boost/function.hpp>
#include <boost/shared_ptr.hpp>

#include <stdexcept>

using namespace RTT;
using oroforge::test::Probe;

namespace {

struct Calculator {
    int base = 10;
    int add(int x) { return base += x; }
    int peek() const { return base; }
    void swap(int& a, int& b) const { std::swap(a, b); }
    const std::string& name(const std::string& in) const { return in; }
};

int doubled(int x) { return 2 * x; }

TEST(AddOperation, TakesEverythingThatCanBeCalled) {
    Probe c;
    Calculator calculator;
    boost::shared_ptr<Calculator> shared(new Calculator);
    const Calculator constant;
    boost::function<int(int)> function = &doubled;

    c.addOperation("member", &Calculator::add, &calculator);
    c.addOperation("const_member", &Calculator::peek, &calculator);
    c.addOperation("of_const", &Calculator::peek, &constant);
    c.addOperation("of_shared", &Calculator::add, shared);
    c.addOperation("free", &doubled);
    c.addOperation("function", function);
    c.addOperation("lambda", [](double x) { return x / 2; });
    int count = 0;
    c.addOperation("mutable_lambda", [&count, n = 0]() mutable { return count = ++n; });

    EXPECT_EQ(OperationCaller<int(int)>(c.getOperation("member"))(5), 15);
    EXPECT_EQ(OperationCaller<int()>(c.getOperation("const_member"))(), 15);
    EXPECT_EQ(OperationCaller<int()>(c.getOperation("of_const"))(), 10);
    EXPECT_EQ(OperationCaller<int(int)>(c.getOperation("of_shared"))(1), 11);
    EXPECT_EQ(OperationCaller<int(int)>(c.getOperation("free"))(4), 8);
    EXPECT_EQ(OperationCaller<int(int)>(c.getOperation("function"))(4), 8);
    EXPECT_EQ(OperationCaller<double(double)>(c.getOperation("lambda"))(5.0), 2.5);
    OperationCaller<int()> mutableLambda = c.getOperation("mutable_lambda");
    mutableLambda();
    EXPECT_EQ(mutableLambda(), 2);
}

TEST(AddOperation, TakesOperationObjects) {
    struct WithOperations : Probe {
        Operation<int(int)> one{"one"}, two{"two", &doubled}, three{"three", &WithOperations::triple, this},
            four{"four", boost::bind(&WithOperations::triple, this, boost::placeholders::_1)};
        int triple(int x) { return 3 * x; }
        WithOperations() {
            one.calls([](int x) { return x; });
            addOperation(one).doc("first").arg("x", "a number");
            addOperation(two);
            provides("sub")->addOperation(three);
            addOperation(four);
        }
    } c;
    EXPECT_EQ(OperationCaller<int(int)>(c.getOperation("one"))(4), 4);
    EXPECT_EQ(OperationCaller<int(int)>(c.getOperation("two"))(4), 8);
    EXPECT_EQ(OperationCaller<int(int)>(c.provides("sub")->getOperation("three"))(4), 12);
    EXPECT_EQ(OperationCaller<int(int)>(c.getOperation("four"))(4), 12);
    EXPECT_EQ(c.getOperation("one")->description(), "first");
}

TEST(AddOperation, RefusesUnboundAndUnnamedOnes) {
    Probe c;
    Operation<void()> unbound("unbound"), unnamed("", [] {});
    c.addOperation(unbound);
    c.addOperation(unnamed);
    EXPECT_FALSE(c.provides()->hasOperation("unbound"));
    EXPECT_FALSE(c.provides()->hasOperation(""));
}

TEST(AddOperation, ReplacesOneOfTheSameName) {
    Probe c;
    c.addOperation("op", [] { return 1; });
    OperationCaller<int()> before = c.getOperation("op");
    c.addOperation("op", [] { return 2; });
    OperationCaller<int()> after = c.getOperation("op");
    EXPECT_EQ(before(), 1) << "a caller keeps what it was bound to";
    EXPECT_EQ(after(), 2);
}

TEST(RemoveOperation, LeavesNothingBehind) {
    Probe c;
    c.addOperation("op", [] { return 1; });
    OperationCaller<int()> op = c.getOperation("op");
    c.provides()->removeOperation("op");
    EXPECT_FALSE(c.provides()->hasOperation("op"));
    EXPECT_EQ(c.getOperation("op"), nullptr);
    EXPECT_EQ(op(), 1);
}

TEST(Arguments, ByReferenceAreWrittenBack) {
    Probe c;
    Calculator calculator;
    c.addOperation("swap", &Calculator::swap, &calculator);
    c.addOperation("name", &Calculator::name, &calculator);
    OperationCaller<void(int&, int&)> swap = c.getOperation("swap");
    int a = 1, b = 2;
    swap(a, b);
    EXPECT_EQ(a, 2);
    EXPECT_EQ(b, 1);
    OperationCaller<const std::string&(const std::string&)> name = c.getOperation("name");
    const std::string text = "text";
    EXPECT_EQ(&name(text), &text);
}

TEST(Arguments, CanBeMany) {
    Probe c;
    c.addOperation("sum", [](int a, int b, int c, int d, int e, int f, int g, int h, int i) {
        return a + b + c + d + e + f + g + h + i;
    });
    OperationCaller<int(int, int, int, int, int, int, int, int, int)> sum = c.getOperation("sum");
    EXPECT_EQ(sum(1, 2, 3, 4, 5, 6, 7, 8, 9), 45);
}

TEST(Caller, FromEverySource) {
    Probe c;
    c.addOperation("op", [](int x) { return x > 0; });
    const auto service = c.provides();

    OperationCaller<bool(int)> unbound;
    EXPECT_FALSE(unbound.ready());
    EXPECT_FALSE(unbound(1)) << "a default value";

    OperationCaller<bool(int)> implicit = c.getOperation("op");
    OperationCaller<bool(int)> fromPart(c.getOperation("op"), c.engine());
    OperationCaller<bool(int)> fromService("op", service);
    OperationCaller<bool(int)> copy(fromPart);
    OperationCaller<bool(int)> named("op");
    named = service;
    OperationCaller<bool(int)> assigned;
    assigned = c.getOperation("op");
    OperationCaller<bool(int)> copied;
    copied = implicit;
    OperationCaller<bool(int)> implementation;
    implementation = service->getLocalOperation("op");
    for (const auto* op : {&implicit, &fromPart, &fromService, &copy, &named, &assigned, &copied, &implementation}) {
        EXPECT_TRUE(op->ready());
        EXPECT_TRUE((*op)(1));
        EXPECT_TRUE(op->call(1));
    }
    EXPECT_EQ(fromService.getName(), "op");
    EXPECT_EQ(assigned.getName(), "op");
    copied.disconnect();
    EXPECT_FALSE(copied.ready());
}

TEST(Caller, IsNotReadyForMissingOperationsAndOtherSignatures) {
    Probe c;
    c.addOperation("op", [](int x) { return x; });
    EXPECT_FALSE(OperationCaller<int(int)>(c.getOperation("missing")).ready());
    EXPECT_FALSE(OperationCaller<int(int)>("missing", c.provides()).ready());
    EXPECT_FALSE(OperationCaller<int(int)>("op", Service::shared_ptr()).ready());
    OperationCaller<std::string(int, int)> wrong = c.getOperation("op");
    EXPECT_FALSE(wrong.ready());
    EXPECT_EQ(wrong(1, 2), "");
}

TEST(Caller, KeepsWorkingWhenTheOperationObjectOfADestroyedServiceIsGone) {
    OperationCaller<int()> op;
    {
        Service::shared_ptr service(new Service("free"));
        service->addOperation("op", [] { return 3; });
        op = service->getOperation("op");
    }
    EXPECT_EQ(op(), 3);
}

TEST(ClientThread, IsTheDefaultAndRunsInTheCaller) {
    Probe c;
    c.addOperation("who", [] { return std::this_thread::get_id(); });
    OperationCaller<std::thread::id()> who = c.getOperation("who");
    EXPECT_EQ(who(), std::this_thread::get_id());
}

TEST(ClientThread, ExceptionsReachTheCallerUnchanged) {
    struct Special {
        int code;
    };
    Probe c;
    ASSERT_TRUE(c.start());
    c.addOperation("bad", [] { throw Special{7}; });
    OperationCaller<void()> bad = c.getOperation("bad");
    try {
        bad();
        FAIL();
    } catch (const Special& special) {
        EXPECT_EQ(special.code, 7);
    }
    EXPECT_TRUE(c.isRunning());
}

TEST(Documentation, IsCompletedForMissingArguments) {
    Probe c;
    c.addOperation("op", [](int, const double&, int&) { return 1u; })
        .doc("does it")
        .arg("a", "first")
        .arg("b", "second");
    OperationInterfacePart* part = c.getOperation("op");
    ASSERT_TRUE(part);
    EXPECT_EQ(part->getName(), "op");
    EXPECT_EQ(part->description(), "does it");
    EXPECT_EQ(part->arity(), 3u);
    EXPECT_EQ(part->collectArity(), 2u) << "the result and the argument by reference";
    const auto arguments = part->getArgumentList();
    ASSERT_EQ(arguments.size(), 3u);
    EXPECT_EQ(arguments[0].name, "a");
    EXPECT_EQ(arguments[1].description, "second");
    EXPECT_EQ(arguments[2].name, "arg3");
    EXPECT_EQ(arguments[2].description, "");
}

TEST(Documentation, ExcessArgumentsAreIgnored) {
    Probe c;
    c.addOperation("op", [](int) {}).arg("a", "first").arg("b", "there is none");
    EXPECT_EQ(c.getOperation("op")->getArgumentList().size(), 1u);
}

}  // namespace
