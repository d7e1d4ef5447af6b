// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// One interpreter, many threads.
#include "lua_fixture.hpp"

#include <ocl/HelloWorld.hpp>
#include <rtt/Activity.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <atomic>
#include <thread>

namespace {

using RTT::OperationCaller;

class LuaThreads : public components_test::WithLibrary {
protected:
    OCL::LuaComponent a{"a"}, b{"b"};
};

TEST_F(LuaThreads, ManyThreadsRunOneAtATime) {
    ASSERT_TRUE(a.exec_str("n = 0"));
    std::vector<std::thread> threads;
    std::atomic<int> failed{0};
    for (int t = 0; t != 4; ++t)
        threads.emplace_back([&] {
            for (int i = 0; i != 200; ++i)
                if (!a.exec_str("local before = n for i = 1, 50 do n = n + 1 end assert(n == before + 50)")) ++failed;
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(0, failed);
    EXPECT_TRUE(a.exec_str("assert(n == 4 * 200 * 50)"));
}

// a calls b in b's thread, which calls a in a's thread, while other threads run code in both.
TEST_F(LuaThreads, CallsInACircleDoNotWaitForEachOther) {
    a.addPeer(&b);
    b.addPeer(&a);
    const std::string ping =
        "local tc = rtt.getTC() count = 0\n"
        "tc:addOperation('ping', 'int(int depth)', function(depth)\n"
        "  count = count + 1\n"
        "  if depth == 0 then return 0 end\n"
        "  local other = tc:getPeer(tc:getPeers()[1])\n"
        "  return 1 + other:getOperation('ping')(depth - 1)\n"
        "end, {thread = 'OwnThread'})";
    ASSERT_TRUE(a.exec_str(ping));
    ASSERT_TRUE(b.exec_str(ping));
    std::vector<std::thread> threads;
    std::atomic<int> wrong{0};
    for (int t = 0; t != 4; ++t)
        threads.emplace_back([&, t] {
            OperationCaller<int(int)> call((t % 2 ? a : b).getOperation("ping"));
            for (int i = 0; i != 50; ++i) {
                if (call(6) != 6) ++wrong;
                if (!(t % 2 ? b : a).exec_str("x = {} collectgarbage('step')")) ++wrong;
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(0, wrong);
}

TEST_F(LuaThreads, HooksAndOtherThreadsShareTheInterpreter) {
    a.setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, 0.001));
    ASSERT_TRUE(
        a.exec_str("cycles = 0 outport = rtt.OutputPort.new('double', 'o') rtt.getTC():addPort(outport)\n"
                   "function updateHook() cycles = cycles + 1 outport:write(cycles) end"));
    ASSERT_TRUE(a.configure());
    ASSERT_TRUE(a.start());
    for (int i = 0; i != 300; ++i) ASSERT_TRUE(a.exec_str("local v = rtt.Variable.new('array') v:resize(10)"));
    for (int i = 0; i != 2000; ++i) {
        if (a.exec_str("assert(cycles > 20)")) break;
        usleep(1000);
    }
    EXPECT_TRUE(a.exec_str("assert(cycles > 20)"));
    a.stop();
}

TEST_F(LuaThreads, AComponentMayBeDestroyedWhileOthersCallIt) {
    for (int round = 0; round != 20; ++round) {
        auto* const gone = new OCL::LuaComponent("gone");
        ASSERT_TRUE(
            gone->exec_str("rtt.getTC():addOperation('f', 'int(int x)', function(x) return x + 1 end, "
                           "{thread = 'OwnThread'})"));
        OperationCaller<int(int)> call(gone->getOperation("f"));
        std::atomic<bool> over{false};
        std::thread caller([&] {
            while (!over) {
                try {
                    (void)call(1);
                } catch (const std::exception&) {
                    break;
                }
            }
        });
        usleep(2000);
        delete gone;
        over = true;
        caller.join();
    }
}

TEST_F(LuaThreads, ComponentsMayBeDestroyedWhileLuaCodeUsesThem) {
    for (int round = 0; round != 50; ++round) {
        auto* const peer = new OCL::HelloWorld("peer");
        a.addPeer(peer);
        ASSERT_TRUE(
            a.exec_str("peer = rtt.getTC():getPeer('peer') property = peer:getProperty('the_property')\n"
                       "port = peer:getPort('the_results') op = peer:getOperation('the_method')"));
        std::thread user([this] {
            EXPECT_TRUE(
                a.exec_str("local function use()\n"
                           "  peer:getState() peer:getPortNames() peer:getOps() property:get() port:info() op()\n"
                           "end\n"
                           "for i = 1, 1e6 do if not pcall(use) then break end end"));
        });
        usleep(500);
        delete peer;
        user.join();
    }
}

TEST_F(LuaThreads, EngineHooksRunUntilTheyReturnFalse) {
    a.setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, 0.001));
    ASSERT_TRUE(a.configure());
    ASSERT_TRUE(a.start());
    ASSERT_TRUE(
        a.exec_str("hits = 0 function hook() hits = hits + 1 return hits < 5 end\n"
                   "h = rtt.EEHook.new('hook') assert(h:enable())"));
    for (int i = 0; i != 2000 && !a.exec_str("assert(hits == 5)"); ++i) usleep(1000);
    usleep(10000);
    EXPECT_TRUE(a.exec_str("assert(hits == 5)"));
    ASSERT_TRUE(a.exec_str("missing = rtt.EEHook.new('no_such_function') assert(missing:enable())"));
    usleep(10000);
    EXPECT_TRUE(a.isRunning());
}

}  // namespace
