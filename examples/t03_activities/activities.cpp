// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The same component under different activities: who executes its updateHook(), and when.
#include <rtt/RTT.hpp>
#include <rtt/extras/FileDescriptorActivity.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/extras/SimulationActivity.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/os/TimeService.hpp>
#include <rtt/os/main.h>

#include <atomic>
#include <chrono>
#include <iostream>
#include <thread>
#include <unistd.h>

using namespace RTT;

namespace {

class Counter : public TaskContext {
public:
    explicit Counter(const std::string& name) : TaskContext(name) {}
    ~Counter() override { stopForGood(); }

    int steps() const { return steps_; }
    /** Seconds from the first step to the last, on the clock of components. */
    double elapsed() const { return static_cast<double>(lastTime_ - firstTime_) * 1e-9; }
    bool inThread(std::thread::id id) const { return last_.load() == id; }

private:
    void updateHook() override {
        last_ = std::this_thread::get_id();
        lastTime_ = os::TimeService::Instance()->getNSecs();
        if (steps_ == 0) firstTime_ = lastTime_;
        ++steps_;
    }
    nsecs firstTime_ = 0, lastTime_ = 0;  // written before steps_
    std::atomic<int> steps_{0};
    std::atomic<std::thread::id> last_{};
};

template <class Condition>
void waitUntil(Condition condition) {
    while (!condition()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

const char* yesNo(bool value) { return value ? "yes" : "no"; }

void ownThread() {
    Counter counter("counter");  // components start with a thread of their own, not periodic
    counter.start();             // start() triggers once
    waitUntil([&] { return counter.steps() == 1; });
    counter.trigger();
    waitUntil([&] { return counter.steps() == 2; });
    std::cout << "own thread: 2 steps, in this thread: " << yesNo(counter.inThread(std::this_thread::get_id())) << "\n";
}

void sequential() {
    Counter counter("counter");
    counter.setActivity(new extras::SequentialActivity());
    counter.start();
    counter.trigger();
    std::cout << "sequential: " << counter.steps()
              << " steps, in this thread: " << yesNo(counter.inThread(std::this_thread::get_id())) << "\n";
}

/** Executes its peers in the order it likes; they are its slaves. */
class Master : public TaskContext {
public:
    explicit Master(const std::string& name) : TaskContext(name) {}
    ~Master() override { stopForGood(); }

private:
    void updateHook() override {
        for (const std::string& name : getPeerList()) getPeer(name)->update();
    }
};

void simulatedMasterAndSlave() {
    const auto simulation = extras::SimulationThread::Instance(0.01);
    Master master("master");
    Counter slave("slave");
    master.setActivity(new extras::SimulationActivity(0.01));
    slave.setActivity(new extras::SlaveActivity(master.getActivity()));
    master.addPeer(&slave);
    slave.start();
    master.start();
    const auto begin = std::chrono::steady_clock::now();
    simulation->run(6000);
    const bool fast = std::chrono::steady_clock::now() - begin < std::chrono::seconds(30);
    std::cout << "simulation: " << slave.steps() << " steps of the slave in " << slave.elapsed()
              << " s of its time, within half a minute of ours: " << yesNo(fast) << "\n";
}

/** Echoes what arrives at a file descriptor. */
class Reader : public TaskContext {
public:
    Reader(const std::string& name, int fd) : TaskContext(name), fd_(fd) {
        setActivity(new extras::FileDescriptorActivity(ORO_SCHED_OTHER, os::LowestPriority));
    }
    ~Reader() override { stopForGood(); }

    std::atomic<bool> done{false};

private:
    bool startHook() override {
        auto* const activity = dynamic_cast<extras::FileDescriptorActivityInterface*>(getActivity());
        if (activity) activity->watch(fd_);
        return activity;
    }
    void updateHook() override {
        auto* const activity = dynamic_cast<extras::FileDescriptorActivityInterface*>(getActivity());
        if (!activity->isUpdated(fd_)) return;
        char text[16];
        const ssize_t size = read(fd_, text, sizeof text);
        std::cout << "file descriptor: " << std::string(text, size > 0 ? size : 0) << "\n";
        done = true;
    }
    const int fd_;
};

void fileDescriptor() {
    int ends[2];
    if (pipe(ends) != 0) return;
    {
        Reader reader("reader", ends[0]);
        reader.start();
        if (write(ends[1], "hello", 5) == 5) waitUntil([&] { return reader.done.load(); });
    }
    close(ends[0]);
    close(ends[1]);
}

}  // namespace

int ORO_main(int, char**) {
    ownThread();
    sequential();
    simulatedMasterAndSlave();
    fileDescriptor();
    return 0;
}
