// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_UNIT_OPERATIONS_PROBE_HPP
#define OROFORGE_TESTS_UNIT_OPERATIONS_PROBE_HPP

#include <rtt/TaskContext.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/os/TimeService.hpp>

#include <atomic>
#include <functional>
#include <gtest/gtest.h>
#include <mutex>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

namespace oroforge::test {

/** Waits, generously, until something becomes true. */
template <class Predicate>
bool eventually(Predicate&& predicate, double seconds = 20.0) {
    const auto start = RTT::os::TimeService::Instance()->getNSecs();
    while (!predicate()) {
        if (RTT::os::TimeService::Instance()->getNSecs() - start > seconds * 1e9) return false;
        usleep(200);
    }
    return true;
}

/** A component that writes down which hooks are called, and does in them what the test says. */
class Probe : public RTT::TaskContext {
public:
    explicit Probe(const std::string& name = "probe", TaskState initial = Stopped) : RTT::TaskContext(name, initial) {}
    ~Probe() override {
        stop();
        if (getActivity()) getActivity()->stop();
    }

    using RTT::TaskContext::exception;
    using RTT::TaskContext::fatal;

    std::function<bool()> onConfigure, onStart;
    std::function<void()> onUpdate, onError, onStop, onCleanup, onException;
    std::atomic<int> updates{0}, errors{0};

    /** The hooks called since the last time, with spaces between; updateHook() and errorHook() are counted instead. */
    std::string takeHooks() {
        std::lock_guard<std::mutex> lock(mutex_);
        std::string taken;
        taken.swap(hooks_);
        return taken;
    }
    void note(const std::string& what) {
        std::lock_guard<std::mutex> lock(mutex_);
        hooks_ += (hooks_.empty() ? "" : " ") + what;
    }

protected:
    bool configureHook() override { return note("configure"), onConfigure ? onConfigure() : true; }
    bool startHook() override { return note("start"), onStart ? onStart() : true; }
    void updateHook() override {
        if (onUpdate) onUpdate();
        ++updates;
    }
    void errorHook() override {
        if (onError) onError();
        ++errors;
    }
    void stopHook() override {
        note("stop");
        if (onStop) onStop();
    }
    void cleanupHook() override {
        note("cleanup");
        if (onCleanup) onCleanup();
    }
    void exceptionHook() override {
        note("exception");
        if (onException) onException();
    }

private:
    std::mutex mutex_;
    std::string hooks_;
};

/** A message that says when it was executed or disposed of. */
struct Note : RTT::base::DisposableInterface {
    explicit Note(std::function<void()> action = {}) : onExecute(std::move(action)) {}
    std::function<void()> onExecute;
    std::atomic<int> executed{0}, disposed{0};
    void executeAndDispose() override {
        if (onExecute) onExecute();
        ++executed;
    }
    void dispose() override { ++disposed; }
};

struct Steps : RTT::base::ExecutableInterface {
    explicit Steps(std::function<bool()> step) : onExecute(std::move(step)) {}
    std::function<bool()> onExecute;
    std::atomic<int> executions{0};
    bool execute() override {
        ++executions;
        return onExecute();
    }
};

/** Steps are made by calling update(). */
inline void makeManual(Probe& probe) { ASSERT_TRUE(probe.setActivity(new RTT::extras::SlaveActivity())); }

}  // namespace oroforge::test

#endif
