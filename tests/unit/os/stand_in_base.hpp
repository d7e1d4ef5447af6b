// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component that no thread executes just now.
#ifndef OROFORGE_TESTS_UNIT_OS_STAND_IN_BASE_HPP
#define OROFORGE_TESTS_UNIT_OS_STAND_IN_BASE_HPP

#include "os_test.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/Activities.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <functional>
#include <memory>
#include <thread>
#include <utility>

namespace stand_in {

using namespace RTT;
using extras::SimulationThread;
using oroforge::test::eventually;

struct Forever : base::ExecutableInterface {
    bool execute() override { return ++executions != 0; }
    std::atomic<int> executions{0};
};

/** Counts threads that are inside at the same time. */
struct Server : TaskContext {
    std::atomic<int> inside{0}, together{0}, updates{0};
    Server() : TaskContext("server") { addOperation("twice", &Server::twice, this, OwnThread); }
    ~Server() override {
        stop();
        getActivity()->stop();
    }
    int twice(int n) {
        visit();
        return 2 * n;
    }
    void updateHook() override {
        visit();
        ++updates;
    }
    void visit() {
        if (++inside != 1) ++together;
        --inside;
    }
};

struct StandInBase {
    std::unique_ptr<TaskContext> master = std::make_unique<TaskContext>("master");
    extras::TimerThreadPtr timer;
    Server server;
    ~StandInBase() { SimulationThread::Release(); }

    void take(base::ActivityInterface* activity) {
        ASSERT_TRUE(server.setActivity(activity));
        ASSERT_TRUE(server.isActive());
    }
    void inAnotherThread(const std::function<void()>& action) { std::thread(action).join(); }
    void prepare(const std::string& kind) {
        const auto isOneOf = [&](const std::string& of) { return kind.compare(0, of.size(), of) == 0; };
        if (isOneOf("simulation")) take(new extras::SimulationActivity(0.001));
        if (kind == "simulation_that_ran") inAnotherThread([] { SimulationThread::Instance()->run(2); });
        if (isOneOf("sequential")) take(new extras::SequentialActivity);
        if (kind == "slave" || kind == "slave_left" || kind == "slave_stopped") take(new extras::SlaveActivity);
        if (kind == "slave_left") inAnotherThread([this] { EXPECT_TRUE(server.update()); });
        if (kind == "slave_orphan" || kind == "slave_of_a_stopped_master")
            take(new extras::SlaveActivity(master->getActivity()));
        if (kind == "slave_orphan") master.reset();
        if (kind == "slave_of_a_stopped_master") {
            ASSERT_TRUE(eventually([&] { return master->getActivity()->stop(); }));
        }
        if (kind == "periodic_of_a_stopped_thread") {
            timer.reset(new extras::TimerThread(ORO_SCHED_OTHER, 0, "timer", 0.001));
            take(new extras::PeriodicActivity(timer));
            ASSERT_TRUE(eventually([&] { return timer->stop(); }));
        }
        if (kind == "simulation_stopped" || kind == "sequential_stopped" || kind == "slave_stopped") {
            ASSERT_TRUE(server.getActivity()->stop());
        }
    }
};

inline std::string nameOf(const testing::TestParamInfo<const char*>& info) { return info.param; }

/** A thread that is joined at the end of the scope, also if that is left by a failed assertion or an exception. */
class Joined {
public:
    explicit Joined(std::function<void()> action) : thread_(std::move(action)) {}
    ~Joined() { join(); }
    Joined(const Joined&) = delete;
    Joined& operator=(const Joined&) = delete;
    void join() {
        if (thread_.joinable()) thread_.join();
    }

private:
    std::thread thread_;
};

/** A thread that repeats an action until the end of the scope, also if that is left by a failed assertion. */
class Repeated {
public:
    explicit Repeated(const std::function<void()>& action)
        : thread_([this, action] {
              while (!end_) action();
          }) {}
    ~Repeated() { finish(); }
    void finish() {
        end_ = true;
        thread_.join();
    }

private:
    std::atomic<bool> end_{false};
    Joined thread_;
};

/** A thread that executes the server until leave(). */
class Updater {
public:
    explicit Updater(StandInBase& base) {
        waiting_.action = [this] {
            inside_ = true;
            EXPECT_TRUE(eventually([this] { return leave_.load(); }));
        };
        EXPECT_TRUE(base.server.engine()->runFunction(&waiting_));
        thread_ = std::thread([&base] { EXPECT_TRUE(base.server.update()); });
        EXPECT_TRUE(eventually([this] { return inside_.load(); }));
    }
    ~Updater() {
        leave_ = true;
        thread_.join();
    }
    void leave() { leave_ = true; }

private:
    struct Waiting : base::ExecutableInterface {
        std::function<void()> action;
        bool execute() override { return action(), false; }
    } waiting_;
    std::atomic<bool> inside_{false}, leave_{false};
    std::thread thread_;
};

}  // namespace stand_in

#endif
