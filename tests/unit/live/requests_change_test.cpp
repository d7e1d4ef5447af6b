// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Changing a deployment: set, call, lifecycle, stop.
#include "requests_fixture.hpp"

#include <support/real_time_trap.hpp>

#include <live/requests/component_thread.hpp>
#include <live/requests/failure.hpp>

#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <unit/flow/log_capture.hpp>

namespace live_test {
namespace {

using oroforge::test::RealTimeTrap;
using testing::HasSubstr;
using testing::StartsWith;

TEST_F(RequestsTest, AValueIsSetAsJsonAndAsText) {
    EXPECT_EQ(3.5, result("set", {{"path", "Arm.gain"}, {"value", 3.5}})["value"]);
    EXPECT_EQ(3.5, arm->gain);
    EXPECT_EQ(4, result("set", {{"path", "Arm.gain"}, {"text", "4"}})["value"]);
    EXPECT_EQ("[1, 5]", result("set", {{"path", "Arm.list"}, {"text", "[1, 5]"}})["text"]);
    EXPECT_EQ(2u, arm->list.size());
    (void)result("set", {{"path", "Arm.list[1]"}, {"value", 8}});
    EXPECT_EQ(8, arm->list[1]);
    (void)result("set", {{"path", "Arm.label"}, {"text", "right hand"}});
    EXPECT_EQ("right hand", arm->label);
    (void)result("set", {{"path", "Arm.label"}, {"text", "\"a\\n\""}});
    EXPECT_EQ("a\n", arm->label);
    (void)result("set", {{"path", "Arm.flag"}, {"text", "true"}});
    EXPECT_TRUE(arm->flag);
    (void)result("set", {{"path", "Arm.count"}, {"text", "0x10"}});
    EXPECT_EQ(16, arm->count);
    (void)result("set", {{"path", "Arm.gripper.force"}, {"value", 1}});
    EXPECT_EQ(1, arm->force);
}

TEST_F(RequestsTest, AFieldOfAStructIsReadAndSet) {
    EXPECT_EQ(12, result("get", {{"path", "Arm.policy.size"}})["value"]);
    const json whole = result("get", {{"path", "Arm.policy"}});
    EXPECT_EQ(12, whole["value"]["size"]);
    EXPECT_EQ(20, result("set", {{"path", "Arm.policy.size"}, {"value", 20}})["value"]);
    EXPECT_EQ(20, arm->policy.size);
    (void)result("set", {{"path", "Arm.policy"}, {"text", "{size = 5, name_id = \"topic\"}"}});
    EXPECT_EQ(5, arm->policy.size);
    EXPECT_EQ("topic", arm->policy.name_id);
    EXPECT_EQ(RTT::ConnPolicy::BUFFER, arm->policy.type);
    // What the console shows can be given back.
    (void)result("set", {{"path", "Arm.policy"}, {"text", whole["text"]}});
    EXPECT_EQ(12, arm->policy.size);
    EXPECT_THAT(failure("get", {{"path", "Arm.policy.siz"}}),
                StartsWith("LIV003: 'Arm.policy', of type ConnPolicy, has no field 'siz'; did you mean 'size'?"));
    EXPECT_THAT(failure("set", {{"path", "Arm.policy"}, {"value", {{"size", "a"}}}}), HasSubstr("Arm.policy: size: "));
}

TEST_F(RequestsTest, ABagOfPropertiesIsSetInPartsAndAsAWhole) {
    EXPECT_EQ(2, result("set", {{"path", "Arm.pid.p"}, {"value", 2}})["value"]);
    EXPECT_EQ(2, arm->bag.getPropertyType<double>("p")->rvalue());
    (void)result("set", {{"path", "Arm.pid"}, {"text", "{p = 3, mode = \"fast\"}"}});
    EXPECT_EQ(3, arm->bag.getPropertyType<double>("p")->rvalue());
    EXPECT_EQ("fast", arm->bag.getPropertyType<std::string>("mode")->rvalue());
    EXPECT_THAT(failure("set", {{"path", "Arm.pid"}, {"value", {{"mod", 1}}}}),
                StartsWith("LIV006: Arm.pid: there is no property 'mod'; did you mean 'mode'?"));
}

TEST_F(RequestsTest, AWrongValueSaysWhereAndWhatIsExpected) {
    EXPECT_THAT(failure("set", {{"path", "Arm.gain"}, {"value", "a"}}),
                StartsWith("LIV006: Arm.gain: found \"a\", expected a number"));
    EXPECT_THAT(failure("set", {{"path", "Arm.list"}, {"value", {1, true}}}), HasSubstr("Arm.list: [1]"));
    EXPECT_THAT(failure("set", {{"path", "Arm.list"}, {"text", "[1, 2"}}),
                StartsWith("LIV006: Arm.list: letter 6: found the end of the value, expected ',' or ']'"));
    EXPECT_THAT(failure("set", {{"path", "Arm.list"}, {"text", "[1, … 98 more]"}}), HasSubstr("a value that was cut"));
    EXPECT_THAT(failure("set", {{"path", "Arm.limit"}, {"value", 1}}), StartsWith("LIV007: 'Arm.limit' is a constant"));
    EXPECT_THAT(failure("set", {{"path", "Arm.out"}, {"value", 1}}), StartsWith("LIV007: 'Arm.out' is a port"));
    EXPECT_THAT(failure("set", {{"path", "Arm.gain"}}), StartsWith("LIV001: the request has no value"));
    EXPECT_THAT(failure("set", {{"path", "Arm.gain"}, {"value", 1}, {"text", "1"}}), StartsWith("LIV001"));
    EXPECT_EQ(2.5, arm->gain);
}

TEST_F(RequestsTest, ATextCallsNothing) {
    EXPECT_THAT(failure("set", {{"path", "Arm.gain"}, {"text", "Arm.add(1, 2)"}}), StartsWith("LIV006"));
}

TEST_F(RequestsTest, AnOperationIsCalledInTheThreadOfItsComponent) {
    const json sum = result("call", {{"path", "Arm.add"}, {"arguments", {1, "2.5"}}});
    EXPECT_EQ(3.5, sum["value"]);
    EXPECT_EQ("double", sum["type"]);
    const std::thread::id own = arm->calledIn;
    (void)result("call", {{"path", "Arm.add"}, {"arguments", {1, 2}}});
    EXPECT_EQ(own, arm->calledIn.load());
    EXPECT_NE(own, std::this_thread::get_id());
    EXPECT_EQ(7, result("call", {{"path", "Arm.addHere"}, {"arguments", {3, 4}}})["value"]);
    EXPECT_EQ("void", result("call", {{"path", "Arm.gripper.open"}})["type"]);
    const json doubled = result("call", {{"path", "Arm.doubles"}, {"arguments", {21}}});
    EXPECT_EQ(42, doubled["arguments"][0]["value"]);
    EXPECT_EQ("x", doubled["arguments"][0]["name"]);
}

TEST_F(RequestsTest, AWrongCallSaysWhy) {
    EXPECT_EQ("LIV006: operation 'Arm.add' has 2 arguments, found 1",
              failure("call", {{"path", "Arm.add"}, {"arguments", {1}}}));
    EXPECT_THAT(failure("call", {{"path", "Arm.add"}, {"arguments", {1, "x"}}}),
                StartsWith("LIV006: argument 2 ('b'): found \"x\", expected a number"));
    EXPECT_THAT(failure("call", {{"path", "Arm.ad"}}),
                HasSubstr("LIV003: there is no operation 'ad' in 'Arm'; did you"));
    EXPECT_THAT(failure("call", {{"path", "Arm"}}), StartsWith("LIV003: 'Arm' is a component, expected an operation"));
    EXPECT_THAT(failure("call", {{"path", "Arm.add"}, {"arguments", 1}}), StartsWith("LIV001"));
    EXPECT_THAT(failure("call", {{"path", "Arm.fails"}}), HasSubstr("no power"));
    EXPECT_EQ("Exception", result("show", {{"path", "Arm"}})["state"]);
}

TEST_F(RequestsTest, ACallThatTakesTooLongIsAnsweredWithAnErrorAndHoldsUpNobody) {
    // A part of the time has passed when the component is asked.
    EXPECT_THAT(failure("call", {{"path", "Arm.block"}, {"timeout", 0.1}}),
                testing::MatchesRegex("LIV004: component 'Arm' did not end this within 0[.][01][0-9]* s; it is still "
                                      "executing it"));
    EXPECT_EQ("Deployer", result("show")["name"]);
    arm->release();
    Arm other("Other");
    deployer->addPeer(&other);
    EXPECT_THAT(failure("call", {{"path", "Other.blockHere"}, {"timeout", 0.1}}),
                StartsWith("LIV004: 'oro.call' was not done within 0.1 s"));
    // A computer under load may take longer than the usual second.
    EXPECT_EQ(2.5, result("get", {{"path", "Other.gain"}, {"timeout", 9}})["value"]);
    other.release();
}

TEST_F(RequestsTest, WhatWasNotBegunInTimeIsNotDoneLater) {
    const auto block = [&](const char* caller) {
        std::vector<std::future<json>> all;
        for (int i = 0; i != 8; ++i)
            all.push_back(askLater({{"op", "oro.call"}, {"path", "Arm.blockHere"}, {"timeout", 5}}, caller));
        return all;
    };
    auto blocked = block("tester");
    EXPECT_THAT(failure("call", {{"path", "Arm.addHere"}, {"arguments", {1, 2}}, {"timeout", 0.1}}),
                StartsWith("LIV004: 'oro.call' was not done within 0.1 s"));
    (void)block("leaver");
    (void)askLater({{"op", "oro.call"}, {"path", "Arm.addHere"}, {"arguments", {1, 2}}}, "leaver");
    requests->left("leaver");
    arm->release();
    for (auto& each : blocked) EXPECT_EQ("oro.answer", each.get()["op"]);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_EQ(std::thread::id(), arm->calledIn.load());
}

TEST_F(RequestsTest, ThreadsOfAClientThatHasLeftAreFreeForOthers) {
    auto blocked = askLater({{"op", "oro.call"}, {"path", "Arm.block"}, {"timeout", 20}});
    while (!arm->blocked) std::this_thread::yield();
    for (int client = 0; client != 16; ++client) {
        const std::string name = "leaver " + std::to_string(client);
        for (int i = 0; i != 4; ++i) {
            (void)askLater({{"op", "oro.get"}, {"path", "Arm.gain"}, {"timeout", 20}}, name);
            (void)askLater({{"op", "oro.top"}, {"seconds", 10}}, name);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        requests->left(name);
    }
    EXPECT_EQ("Deployer", result("show", {{"timeout", 2}})["name"]);
    arm->release();
    EXPECT_EQ("oro.answer", blocked.get()["op"]);
}

TEST_F(RequestsTest, TheThreadOfAComponentFreesNothing) {
    static std::atomic<std::thread::id> freed{}, executed{};  // the last message may be freed after this test
    const auto run = [&](double seconds, int milliseconds) {
        const std::shared_ptr<int> held(new int(0), [](const int* number) {
            freed = std::this_thread::get_id();
            delete number;
        });
        try {
            const OCL::live::Limit limit{OCL::live::deadlineIn(seconds), seconds};
            OCL::live::inThreadOf(arm->engine()->gate(), "Arm", limit, [held, milliseconds] {
                executed = std::this_thread::get_id();
                std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
            });
        } catch (const OCL::live::Failure&) {
        }
    };
    for (int i = 0; i != 200; ++i) {
        run(1, 0);
        EXPECT_NE(executed.load(), freed.load());
    }
    freed = std::thread::id();
    run(0.01, 50);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_NE(executed.load(), freed.load());
    run(1, 0);
    EXPECT_EQ(std::this_thread::get_id(), freed.load()) << "what is left of the last one is freed by the next";
}

TEST_F(RequestsTest, ComponentsThatNothingExecutesAreReadAndCalledAllTheSame) {
    struct Case {
        const char* name;
        RTT::base::ActivityInterface* activity;
    };
    for (const Case each : {Case{"Slave", new RTT::extras::SlaveActivity(0.01)},
                            Case{"Sequential", new RTT::extras::SequentialActivity()},
                            Case{"Periodic", new RTT::Activity(ORO_SCHED_OTHER, 0, 0.01)}}) {
        Arm other(each.name);
        ASSERT_TRUE(other.setActivity(each.activity));
        deployer->addPeer(&other);
        const std::string name = each.name;
        for (const bool running : {false, true}) {
            if (running) {
                ASSERT_TRUE(other.start());
            }
            EXPECT_EQ(2.5, result("get", {{"path", name + ".gain"}})["value"]) << name;
            (void)result("set", {{"path", name + ".gain"}, {"value", 2.5}});
            EXPECT_EQ(3, result("call", {{"path", name + ".add"}, {"arguments", {1, 2}}})["value"]) << name;
        }
        other.stop();
    }
    ASSERT_TRUE(arm->engine()->getActivity()->stop());
    EXPECT_EQ(2.5, result("get", {{"path", "Arm.gain"}})["value"]);
    arm->engine()->getActivity()->start();
}

TEST_F(RequestsTest, AComponentIsConfiguredStartedAndStopped) {
    const auto change = [this](const char* what) { return result("lifecycle", {{"component", "Arm"}, {"do", what}}); };
    EXPECT_EQ((json{{"done", true}, {"state", "Running"}}), change("start"));
    EXPECT_EQ((json{{"done", false}, {"state", "Running"}}), change("start"));
    EXPECT_EQ("Stopped", change("stop")["state"]);
    EXPECT_EQ("PreOperational", change("cleanup")["state"]);
    EXPECT_EQ("Stopped", change("configure")["state"]);
    arm->refusesStart = true;
    EXPECT_EQ(false, change("start")["done"]);
    EXPECT_THAT(failure("lifecycle", {{"component", "Arm"}, {"do", "jump"}}),
                HasSubstr("LIV001: field 'do' is 'jump'"));
    EXPECT_THAT(failure("lifecycle", {{"component", "Amr"}, {"do", "start"}}), HasSubstr("did you mean 'Arm'?"));
    EXPECT_THAT(failure("lifecycle", {{"component", "Arm"}}), StartsWith("LIV001"));
}

TEST_F(RequestsTest, StopEndsTheDeployment) {
    EXPECT_EQ(true, result("stop")["done"]);
    EXPECT_TRUE(stopped);
}

TEST_F(RequestsTest, ChangesAreLoggedWithTheirCaller) {
    flow_test::LogCapture log;
    const auto level = RTT::Logger::Instance()->getLogLevel();
    RTT::Logger::Instance()->setLogLevel(RTT::Logger::Info);
    (void)result("set", {{"path", "Arm.gain"}, {"value", 3}});
    (void)result("call", {{"path", "Arm.add"}, {"arguments", {1, 2}}});
    (void)result("lifecycle", {{"component", "Arm"}, {"do", "start"}});
    const std::string text = log.finish();
    RTT::Logger::Instance()->setLogLevel(level);
    EXPECT_THAT(text, HasSubstr("tester sets Arm.gain = 3 (was 2.5)"));
    EXPECT_THAT(text, HasSubstr("tester calls Arm.add(1, 2)"));
    EXPECT_THAT(text, HasSubstr("tester start() of component 'Arm', which is Running"));
}

TEST_F(RequestsTest, AComponentThatIsDestroyedMeanwhileIsGone) {
    auto other = std::make_unique<Arm>("Other");
    deployer->addPeer(other.get());
    auto blocked = askLater({{"op", "oro.call"}, {"path", "Other.block"}, {"timeout", 5}});
    while (!other->blocked) std::this_thread::yield();
    auto waiting = askLater({{"op", "oro.get"}, {"path", "Other.gain"}, {"timeout", 5}});
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    other.reset();
    EXPECT_EQ("oro.answer", blocked.get()["op"]);
    const json late = waiting.get();
    EXPECT_EQ(late["op"] == "oro.error" ? "LIV008" : "", late.value("code", ""));
    EXPECT_THAT(failure("get", {{"path", "Other.gain"}}), StartsWith("LIV003"));
}

TEST_F(RequestsTest, NothingIsAnsweredOnceTheClientOrTheServerIsGone) {
    std::atomic<int> answers{0};
    const auto ask = [&](const char* caller) {
        requests->handle({{"op", "oro.call"}, {"path", "Arm.block"}}, {caller, rights},
                         [&](const json&) { ++answers; });
    };
    ask("one");
    ask("two");
    while (!arm->blocked) std::this_thread::yield();
    requests->left("one");
    requests.reset();
    arm->release();
    while (arm->blocked) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_EQ(0, answers);
}

TEST_F(RequestsTest, AClientHasSoManyRequestsUnderWayAndHoldsUpNoOther) {
    std::vector<std::future<json>> all;
    for (int i = 0; i != 300; ++i) all.push_back(askLater({{"op", "oro.call"}, {"path", "Arm.blockHere"}}, "greedy"));
    EXPECT_EQ("LIV010", all.back().get()["code"]);
    EXPECT_EQ(2.5, result("get", {{"path", "Arm.gain"}})["value"]);
    arm->release();
    for (std::size_t i = 0; i + 1 != all.size(); ++i) (void)all[i].get();
}

/** Its thread must not allocate while `watches` is true. */
class Careful : public Arm {
public:
    Careful() : Arm("Careful") {
        label = std::string(200, 'a');
        list.assign(100, 1);
    }
    ~Careful() override { stopForGood(); }
    void updateHook() override {
        if (watches == (trap != nullptr)) return;
        if (watches) {
            trap = std::make_unique<RealTimeTrap>(RealTimeTrap::kAllocation | RealTimeTrap::kRelease);
        } else {
            trap->stop();
            trap->forgive();
            calls = trap->caught() != 0 ? trap->report() : "";
            trap.reset();
        }
        isWatched = watches.load();
    }
    void watch(bool on) {
        watches = on;
        while (isWatched != on) trigger(), std::this_thread::yield();
    }
    std::atomic<bool> watches{false}, isWatched{false};
    std::unique_ptr<RealTimeTrap> trap;
    std::string calls;
};

TEST_F(RequestsTest, TextsAndVectorsAreSetAndReadWithoutAllocationInTheThreadOfTheComponent) {
    OROFORGE_NEEDS_REAL_TIME_TRAP();
    Careful careful;
    deployer->addPeer(&careful);
    const std::string text(150, 'b');
    const std::vector<double> numbers(80, 2.5);
    ASSERT_TRUE(careful.start());
    careful.watch(true);
    EXPECT_EQ(text, result("set", {{"path", "Careful.label"}, {"value", text}})["value"]);
    EXPECT_EQ(json(numbers), result("set", {{"path", "Careful.list"}, {"value", numbers}})["value"]);
    EXPECT_EQ(text, result("get", {{"path", "Careful.label"}})["value"]);
    EXPECT_EQ("short", result("set", {{"path", "Careful.label"}, {"text", "\"short\""}})["value"]);
    EXPECT_EQ("component", result("show", {{"path", "Careful"}})["kind"]);
    careful.watch(false);
    EXPECT_EQ("", careful.calls);
    EXPECT_EQ(numbers, careful.list);
}

}  // namespace
}  // namespace live_test
