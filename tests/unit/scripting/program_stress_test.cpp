// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Programs and functions of several components that call each other, while other threads command them.
#include "script_bench.hpp"

#include <rtt/internal/GlobalEngine.hpp>
#include <unit/operations/probe.hpp>
#include <unit/types/builtin_typekit.hpp>

#include <memory>

using namespace RTT;
using oroforge::test::eventually;
using oroforge::test::Probe;
using script_test::ScriptBench;

namespace {

constexpr int kRounds = 150;

/** Three components with a thread each, which know each other. */
struct ProgramStress : types_test::WithBuiltinTypes {
    struct Member {
        explicit Member(const std::string& name) : component(name), scripts(component) {
            component.addAttribute("total", total);
            component.setPeriod(0.0005);
        }
        int total = 0;  // touched by the component's thread
        Probe component;
        ScriptBench scripts;
    };
    ProgramStress() {
        for (Member* member : all) {
            for (Member* other : all)
                if (other != member) member->component.addPeer(&other->component);
            // What is called is there before those who call are compiled.
            EXPECT_EQ(member->scripts.load("export int quick(int a) {\n  total = total + 1\n  return a + 1\n}\n"
                                           "export int slow(int a) {\n  var int i = 0\n"
                                           "  for (i = 0; i < 3; i = i + 1) {\n    total = total + 1\n    yield\n  }\n"
                                           "  return a + i\n}\n"),
                      "");
        }
    }
    ~ProgramStress() override {
        for (Member* member : all) member->component.getActivity()->stop();
    }
    Member a{"a"}, b{"b"}, c{"c"};
    Member* const all[3] = {&a, &b, &c};
};

TEST_F(ProgramStress, ProgramsCallEachOthersFunctions) {
    const std::string caller =
        "program p {\n  var int i = 0\n  var int sum = 0\n  var SendHandle h\n  var int r = 0\n"
        "  while i < " +
        std::to_string(kRounds) +
        " {\n    sum = sum + FIRST.quick(i) - i\n"
        "    sum = sum + SECOND.slow(i) - i - 3\n    h = FIRST.slow.send(i)\n"
        "    while h.collectIfDone(r) == SendNotReady\n      yield\n    sum = sum + r - i - 3\n"
        "    i = i + 1\n    yield\n  }\n  total = total + 1000000 * sum\n}\n";
    const auto load = [&](Member& member, const std::string& first, const std::string& second) {
        std::string text = caller;
        for (std::size_t at; (at = text.find("FIRST")) != std::string::npos;) text.replace(at, 5, first);
        for (std::size_t at; (at = text.find("SECOND")) != std::string::npos;) text.replace(at, 6, second);
        ASSERT_EQ(member.scripts.load(text), "");
    };
    load(a, "b", "c");
    load(b, "c", "a");
    load(c, "a", "b");
    for (Member* member : all) ASSERT_TRUE(member->scripts["p"].start());
    for (Member* member : all) {
        EXPECT_TRUE(eventually([&] { return !member->scripts["p"].isRunning(); }, 120))
            << member->component.getName() << " is in line " << member->scripts["p"].getLineNumber();
        EXPECT_TRUE(member->scripts["p"].isStopped()) << member->scripts["p"].getError();
    }
    for (Member* member : all) {
        member->component.getActivity()->stop();
        // Each was called quick() once and slow() twice, of three parts, in each round, and its own sum is one per round.
        EXPECT_EQ(member->total, 1000000 * kRounds + 7 * kRounds) << member->component.getName();
    }
}

TEST_F(ProgramStress, ThreadsOfNoComponentCallAndSend) {
    std::vector<std::thread> threads;
    std::atomic<int> wrong{0};
    for (int t = 0; t != 3; ++t) {
        Probe& target = all[t]->component;
        threads.emplace_back([&wrong, &target, t] {
            OperationCaller<int(int)> quick(target.getOperation("quick"), internal::GlobalEngine::Instance());
            OperationCaller<int(int)> slow(target.getOperation("slow"), internal::GlobalEngine::Instance());
            for (int i = 0; i != kRounds; ++i) {
                if (quick(i) != i + 1) ++wrong;
                auto handle = slow.send(i);
                if (i % 3 == t) continue;  // nobody ever asks
                int result = 0;
                if (handle.collect(result) != SendSuccess || result != i + 3) ++wrong;
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, 0);
}

TEST_F(ProgramStress, CommandsOfManyThreads) {
    ASSERT_EQ(
        a.scripts.load("program p {\n  while true {\n    total = total + 1\n    yield\n    total = total + 1\n  }\n}"),
        "");
    scripting::ProgramInterface& p = a.scripts["p"];
    std::vector<std::thread> threads;
    for (int t = 0; t != 4; ++t)
        threads.emplace_back([&p, t] {
            for (int i = 0; i != 20 * kRounds; ++i) {
                switch ((i + t) % 5) {
                    case 0: p.start(); break;
                    case 1: p.pause(); break;
                    case 2: p.step(); break;
                    case 3: p.stop(); break;
                    default: p.getLineNumber(), p.getStatus();
                }
                if (i % 50 == 0) usleep(300);
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_TRUE(p.stop());
    EXPECT_TRUE(p.start());
    EXPECT_TRUE(eventually([&] { return p.isRunning() && p.getLineNumber() == 5; })) << p.getProgramStatusStr();
}

TEST_F(ProgramStress, ThoseThatWereStoppedAreStartedAgainAndAgainByOtherThreads) {
    constexpr int kPrograms = 3;
    std::string text;
    for (int i = 0; i != kPrograms; ++i) text += "program p" + std::to_string(i) + " { total = total + 1 }\n";
    ASSERT_EQ(a.scripts.load(text), "");
    std::vector<std::thread> threads;
    for (int i = 0; i != kPrograms; ++i)
        threads.emplace_back([&p = a.scripts["p" + std::to_string(i)], i] {
            for (int round = 0; round != kRounds; ++round) {
                ASSERT_TRUE(round % 2 ? p.start() : p.pause() && p.start());
                ASSERT_TRUE(eventually([&] { return p.isStopped(); })) << i << " in round " << round;
            }
        });
    for (std::thread& thread : threads) thread.join();
    a.component.getActivity()->stop();
    EXPECT_EQ(a.total, kPrograms * kRounds);
}

TEST_F(ProgramStress, FunctionsAreRedefinedWhileTheyAreCalled) {
    std::atomic<bool> end{false};
    OperationCaller<int(int)> known(b.component.getOperation("slow"), internal::GlobalEngine::Instance());
    std::thread client([&] {
        for (int i = 0; !end; ++i) ASSERT_EQ(known(i), i + 3);
    });
    for (int i = 0; i != 30; ++i) {
        b.scripts.load("export int slow(int a) {\n  yield\n  return a - 1\n}");
        OperationCaller<int(int)> fresh(b.component.getOperation("slow"), internal::GlobalEngine::Instance());
        EXPECT_EQ(fresh(i), i - 1);
    }
    end = true;
    client.join();
}

}  // namespace
