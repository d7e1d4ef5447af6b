// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Functions of scripts, called as operations.
#include "script_bench.hpp"

#include <rtt/FactoryExceptions.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/internal/OperationCallerC.hpp>
#include <unit/flow/log_capture.hpp>
#include <unit/operations/probe.hpp>
#include <unit/types/builtin_typekit.hpp>

#include <stdexcept>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Probe;
using script_test::ScriptBench;

namespace {

/** What `action` throws. */
template <class Action>
std::string thrownBy(Action&& action) {
    try {
        action();
    } catch (const std::exception& e) {
        return e.what();
    }
    return "nothing";
}

/** `host` has a thread, `manual` is executed by update(). */
struct ScriptFunctions : types_test::WithBuiltinTypes {
    ScriptFunctions() {
        oroforge::test::makeManual(manual);
        for (Probe* probe : {&host, &manual}) {
            probe->addAttribute("count", count);
            probe->addOperation("isOwn", [probe] { return probe->engine()->isStepping(); });
            probe->addOperation("fail", [] { throw std::runtime_error("the gripper is stuck"); });
        }
    }
    template <class Signature>
    OperationCaller<Signature> caller(Probe& of, const std::string& name, ExecutionEngine* engine = nullptr) {
        return OperationCaller<Signature>(of.getOperation(name), engine ? engine : internal::GlobalEngine::Instance());
    }

    int count = 0;
    flow_test::LogCapture log;
    Probe host{"host"}, manual{"manual"};
    ScriptBench scripts{host}, manualScripts{manual};
};

TEST_F(ScriptFunctions, AreExecutedByTheirComponent) {
    ASSERT_EQ(scripts.load("export int add(int a, int b) {\n  if isOwn() then return a + b\n  return -1\n}"), "");
    auto add = caller<int(int, int)>(host, "add");
    ASSERT_TRUE(add.ready()) << log.text();
    EXPECT_EQ(add(3, 4), 7);
    EXPECT_EQ(add(30, 4), 34);
    EXPECT_EQ(caller<double(double, short)>(host, "add")(2.0, 5), 7.0) << "converted";
}

TEST_F(ScriptFunctions, StandWhereTheirScopeSays) {
    ASSERT_EQ(scripts.load("export void e() {\n}\nlocal void l() {\n}\nfunction n {\n}\nglobal void g() {\n}"), "");
    EXPECT_TRUE(host.provides()->hasMember("e"));
    EXPECT_TRUE(host.provides("scripting")->hasMember("l"));
    EXPECT_TRUE(host.provides("scripting")->hasMember("n"));
    EXPECT_TRUE(internal::GlobalService::Instance()->hasMember("g"));
    EXPECT_FALSE(host.provides()->hasMember("l") || host.provides()->hasMember("g"));
}

TEST_F(ScriptFunctions, TellTheirSignature) {
    ASSERT_EQ(scripts.load("export double scale(string unit, int value) {\n  return value\n}\nexport void act() {\n}"),
              "");
    const OperationInterfacePart& part = *host.getOperation("scale");
    EXPECT_EQ(part.getName(), "scale");
    EXPECT_EQ(part.resultType(), "double");
    EXPECT_EQ(part.arity(), 2u);
    EXPECT_EQ(part.collectArity(), 1u);
    EXPECT_EQ(part.getArgumentList()[0].name, "unit");
    EXPECT_EQ(part.getArgumentList()[0].type, "string");
    EXPECT_EQ(part.getArgumentType(0), types_test::type("double"));
    EXPECT_EQ(part.getArgumentType(2), types_test::type("int"));
    EXPECT_EQ(part.getArgumentType(3), nullptr);
    EXPECT_EQ(part.getCollectType(1), types_test::type("double"));
    EXPECT_EQ(part.getCollectType(2), nullptr);
    EXPECT_EQ(host.getOperation("act")->resultType(), "void");
    EXPECT_EQ(host.getOperation("act")->collectArity(), 0u);
}

TEST_F(ScriptFunctions, RefuseWrongArguments) {
    ASSERT_EQ(scripts.load("export int twice(int a) {\n  return 2 * a\n}"), "");
    const OperationInterfacePart& part = *host.getOperation("twice");
    const auto text = types_test::variable("two");
    EXPECT_THROW(part.produce({}, nullptr), wrong_number_of_args_exception);
    try {
        part.produce({text}, nullptr);
        FAIL();
    } catch (const wrong_types_of_args_exception& e) {
        EXPECT_EQ(e.whicharg, 1);
        EXPECT_EQ(e.expected_, "int");
        EXPECT_EQ(e.received_, "string");
    }
    EXPECT_FALSE((caller<int(std::string)>(host, "twice").ready()));
}

TEST_F(ScriptFunctions, AFailureIsAnExceptionOfTheCaller) {
    ASSERT_EQ(scripts.load("void inner() {\n  fail()\n}\nexport int outer(int a) {\n  inner()\n  return a\n}"), "");
    auto outer = caller<int(int)>(host, "outer");
    EXPECT_EQ(thrownBy([&] { outer(1); }),
              "function 'outer' of component 'host' failed at bench.ops:5:3: the gripper is stuck (at "
              "bench.ops:2:3, in function 'inner')");
    EXPECT_TRUE(host.inException()) << "the operation that threw is its own";
    EXPECT_EQ(thrownBy([&] { outer(1); }).substr(0, 16), "function 'outer'") << "each time";
}

TEST_F(ScriptFunctions, GiveADefaultWithoutReturnAndForgetTheirVariables) {
    ASSERT_EQ(scripts.load("export int f(bool give) {\n  var int i\n  i = i + 1\n  if give then return i\n}"), "");
    auto f = caller<int(bool)>(host, "f");
    EXPECT_EQ(f(true), 1);
    EXPECT_EQ(f(true), 1);
    EXPECT_EQ(f(false), 0);
}

TEST_F(ScriptFunctions, AreContinuedStepByStep) {
    ASSERT_EQ(
        manualScripts.load("export int f(int n) {\n  var int i = 0\n  while i < n {\n    i = i + 1\n    yield\n  }\n"
                           "  return i * 10\n}"),
        "");
    ASSERT_TRUE(manual.start());
    std::atomic<int> result{-1};
    std::thread client([&] { result = caller<int(int)>(manual, "f")(3); });
    EXPECT_TRUE(eventually([&] { return manual.update() && result != -1; }));
    client.join();
    EXPECT_EQ(result, 30);
    EXPECT_GE(manual.updates, 3) << "the component does its own work meanwhile";
}

TEST_F(ScriptFunctions, GoOnInAComponentThatNobodyTriggers) {
    ASSERT_EQ(scripts.load("export int f() {\n  yield\n  yield\n  return 5\n}"), "");
    EXPECT_EQ(caller<int()>(host, "f")(), 5);
    EXPECT_TRUE(
        log.contains("function 'f' of component 'host' yields, and the component has no period: it makes one step "
                     "after the other until the function is done (next is line 3)"))
        << log.text();
}

TEST_F(ScriptFunctions, WithNothingInThemComeToTheirEndForEachCaller) {
    const char* const text =
        "export int f(int n) {\n  if n > 1 then nothing else do nothing\n  return n\n}\n"
        "export void empty() { nothing }";
    ASSERT_EQ(scripts.load(text), "");
    EXPECT_EQ(caller<int(int)>(host, "f")(1), 1) << "another thread";
    EXPECT_EQ(caller<int(int)>(host, "f").send(2).collect(), SendSuccess);
    caller<void()>(host, "empty")();
    ASSERT_EQ(manualScripts.load(text), "");
    auto f = caller<int(int)>(manual, "f", manual.engine());
    int result = 0;
    manual.onUpdate = [&] { result = f(3); };
    ASSERT_TRUE(manual.start());
    ASSERT_TRUE(manual.update());
    EXPECT_EQ(result, 3) << "the component itself";
}

TEST_F(ScriptFunctions, YieldWithinACallOfTheirOwnComponent) {
    ASSERT_EQ(manualScripts.load("export int f() {\n  while count == 0\n    yield\n  return count\n}"), "");
    auto f = caller<int()>(manual, "f", manual.engine());
    manual.addOperation(
        "setCount", [this] { count = 8; }, OwnThread);
    int result = 0;
    manual.onUpdate = [&] {
        auto handle = caller<void()>(manual, "setCount").send();
        result = f();
        EXPECT_EQ(handle.collectIfDone(), SendSuccess) << "messages are executed meanwhile";
    };
    ASSERT_TRUE(manual.start());
    ASSERT_TRUE(manual.update());
    EXPECT_EQ(result, 8);
    EXPECT_TRUE(
        log.contains("function 'f' of component 'manual' yields in a call by the component itself, which executes "
                     "nothing but messages until it is done (next is line 3)"))
        << log.text();
}

TEST_F(ScriptFunctions, ServeTheCallerWhileTheyCallHim) {
    Probe client("client");
    client.addOperation(
        "ask", [] { return 6; }, OwnThread);
    ASSERT_TRUE(host.addPeer(&client));
    ASSERT_EQ(scripts.load("export int f() {\n  return client.ask() * 7\n}"), "");
    auto f = caller<int()>(host, "f", client.engine());
    std::atomic<int> result{0};
    client.onUpdate = [&] { result = f(); };
    ASSERT_TRUE(client.start());
    EXPECT_TRUE(eventually([&] { return result == 42; }));
    client.stop();
}

TEST_F(ScriptFunctions, OnesThatAreReplacedGoOnForThoseWhoKnowThem) {
    ASSERT_EQ(scripts.load("export int f() {\n  return 1\n}"), "");
    auto known = caller<int()>(host, "f");
    EXPECT_EQ(
        scripts.load("export int f() {\n  return 2\n}"),
        "bench.ops:1:12: warning: [OPS205] function 'f' is defined again: what is loaded already goes on with the one "
        "it knows\n");
    EXPECT_EQ(known(), 1);
    EXPECT_EQ((caller<int()>(host, "f")()), 2);
}

TEST_F(ScriptFunctions, DoNotReplaceOtherOperations) {
    host.addOperation("f", [] { return 1; });
    EXPECT_EQ(
        scripts.load("export int f() {\n  return 2\n}"),
        "bench.ops:1:12: error: [OPS204] function 'f' cannot be added: 'host' has an operation of that name, which no "
        "script defined\n");
    EXPECT_EQ((caller<int()>(host, "f")()), 1);
}

TEST_F(ScriptFunctions, OnesThatDoNotCompileAreNotAdded) {
    EXPECT_NE(scripts.load("export int f() {\n  return nowhere\n}"), "");
    EXPECT_FALSE(host.provides()->hasMember("f"));
}

TEST_F(ScriptFunctions, OneThatCallsItselfByItsOperationIsRefused) {
    ASSERT_EQ(scripts.load("export int f() {\n  return 1\n}"), "");
    scripts.load("export int f() {\n  return this.f() + 1\n}");
    // The first execution of the new one has found the old one; the next ones find themselves.
    auto first = caller<int()>(host, "f");
    ASSERT_TRUE(first.ready());
    EXPECT_EQ(first(), 2);
    auto second = caller<int()>(host, "f");
    EXPECT_FALSE(second.ready());
    EXPECT_TRUE(log.contains("[OPS207] function 'f' of component 'host' calls itself")) << log.text();
}

TEST_F(ScriptFunctions, CallsOfALostComponentThrow) {
    auto gone = std::make_unique<Probe>("gone");
    auto goneScripts = std::make_unique<ScriptBench>(*gone);
    ASSERT_EQ(goneScripts->load("global int lost() {\n  return 1\n}"), "");
    OperationInterfacePart* const part = internal::GlobalService::Instance()->getPart("lost");
    OperationCaller<int()> lost(part, internal::GlobalEngine::Instance());
    EXPECT_EQ(lost(), 1);
    goneScripts.reset();
    gone.reset();
    EXPECT_EQ(thrownBy([&] { lost(); }),
              "function 'lost' of component 'gone' was not executed: the component was destroyed");
    EXPECT_EQ(scripts.load("global int lost() {\n  return 2\n}"), "") << "nobody can use the old one";
    internal::GlobalService::Instance()->remove("lost");
}

TEST_F(ScriptFunctions, ACallEndsWhenItsComponentFailsForGood) {
    ASSERT_EQ(manualScripts.load("export void f() {\n  count = 1\n  while true\n    yield\n}"), "");
    std::string thrown;
    std::thread client([&] { thrown = thrownBy([&] { caller<void()>(manual, "f")(); }); });
    ASSERT_TRUE(eventually([&] {
        manual.update();
        return count == 1;
    }));
    manual.fatal();
    client.join();
    EXPECT_EQ(thrown, "function 'f' of component 'manual' was not executed to its end: the component is in FatalError");
    EXPECT_EQ(thrownBy([&] { caller<void()>(manual, "f")(); }),
              "function 'f' of component 'manual' was not executed: the component is in FatalError");
}

TEST_F(ScriptFunctions, AreUnderTheBudgetOfTheirComponent) {
    ASSERT_EQ(scripts.load("export void f() {\n  while true\n    count = count + 1\n}"), "");
    scripts.budget->set(100);
    EXPECT_EQ(
        thrownBy([&] { caller<void()>(host, "f")(); }),
        "function 'f' of component 'host' failed at bench.ops:3:5: the loop went round 100 times in one step of the "
        "component, which is the limit; add a 'yield' to it");
}

TEST_F(ScriptFunctions, AreCalledByProgramsOfOtherComponents) {
    ASSERT_EQ(
        scripts.load(
            "export string greet(string name) {\n  return \"hello \" + name\n}\nexport void broken() {\n  fail()\n}"),
        "");
    ASSERT_TRUE(manual.addPeer(&host));
    std::string said;
    manual.addAttribute("said", said);
    ASSERT_EQ(manualScripts.load(
                  "program p {\n  said = host.greet(\"you\")\n  try host.broken() catch count = 3\n  host.broken()\n}"),
              "");
    ASSERT_TRUE(manualScripts["p"].start());
    ASSERT_TRUE(manual.update());
    EXPECT_EQ(said, "hello you");
    EXPECT_EQ(count, 3);
    EXPECT_EQ(manualScripts["p"].getError(),
              "bench.ops:4:3: error: [OPS400] program 'p' of component 'manual' failed: function 'broken' of component "
              "'host' "
              "failed at bench.ops:5:3: the gripper is stuck");
}

TEST_F(ScriptFunctions, AreCalledByGenericCallers) {
    ASSERT_EQ(scripts.load("export int twice(int a) {\n  return 2 * a\n}"), "");
    int result = 0;
    internal::OperationCallerC generic(host.getOperation("twice"), "twice", nullptr);
    EXPECT_TRUE(generic.argC(21).ret(result).call());
    EXPECT_EQ(result, 42);
}

TEST_F(ScriptFunctions, SourcesAreCopiedWithTheirExpression) {
    ASSERT_EQ(scripts.load("export int twice(int a) {\n  return 2 * a\n}\nexport void keep(int a) {\n  count = a\n}"),
              "");
    const auto value = types_test::variable(4);
    const auto source = host.getOperation("twice")->produce({value}, nullptr);
    std::map<const base::DataSourceBase*, base::DataSourceBase*> cloned;
    const base::DataSourceBase::shared_ptr copy = source->copy(cloned), twin = source->clone();
    EXPECT_EQ(types_test::valueOf<int>(source), 8);
    value->set(5);
    EXPECT_EQ(types_test::valueOf<int>(copy), 10);
    EXPECT_EQ(types_test::valueOf<int>(twin), 10);
    const auto call = host.getOperation("keep")->produce({value}, nullptr);
    EXPECT_TRUE(call->evaluate());
    EXPECT_EQ(count, 5);
    value->set(6);
    cloned.clear();
    EXPECT_TRUE(base::DataSourceBase::shared_ptr(call->copy(cloned))->evaluate());
    EXPECT_EQ(count, 6);
}

}  // namespace
