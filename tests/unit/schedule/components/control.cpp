// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What runs in a replay.
#include "Pose.hpp"

#include <rtt/Activity.hpp>
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>
#include <rtt/os/TimeService.hpp>
#include <rtt/os/fosi.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <random>
#include <thread>

#include <fcntl.h>
#include <sys/random.h>
#include <unistd.h>

namespace replaytest {

/** Is woken by images, and has poses. */
class Viewer : public RTT::TaskContext {
public:
    explicit Viewer(const std::string& name) : RTT::TaskContext(name) {
        addProperty("factor", factor_);
        addEventPort("image", image_);
        addPort("pose", pose_);
        addPort("level", level_);
        addPort("seen", seen_);
        addPort("scaled", scaled_);
        seen_.setDataSample(std::string(60, '.'));
    }
    ~Viewer() override { stopForGood(); }

private:
    void updateHook() override {
        std::string image;
        while (image_.read(image) == RTT::NewData)
            seen_.write(image + " at " + std::to_string(RTT::os::TimeService::Instance()->getNSecs() % 1000000000));
        Pose pose;
        if (pose_.read(pose) == RTT::NewData) scaled_.write(pose.x * factor_);
        int level = 0;
        (void)level_.read(level);
    }

    double factor_ = 2;
    RTT::InputPort<std::string> image_;
    RTT::InputPort<Pose> pose_;
    RTT::InputPort<int> level_;
    RTT::OutputPort<std::string> seen_;
    RTT::OutputPort<double> scaled_;
};

/** Sends the time in each period. */
class Ticker : public RTT::TaskContext {
public:
    explicit Ticker(const std::string& name) : RTT::TaskContext(name) {
        addPort("tick", tick_);
        setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, 0.01, nullptr, name));
    }
    ~Ticker() override { stopForGood(); }

private:
    void updateHook() override { tick_.write(RTT::os::TimeService::Instance()->getSeconds()); }
    RTT::OutputPort<double> tick_;
};

/** Triggers itself again and again. */
class Restless : public RTT::TaskContext {
public:
    explicit Restless(const std::string& name) : RTT::TaskContext(name) {}
    ~Restless() override { stopForGood(); }

private:
    void updateHook() override { trigger(); }
};

/** Does what a replay cannot repeat. */
class Worldly : public RTT::TaskContext {
public:
    explicit Worldly(const std::string& name) : RTT::TaskContext(name) {
        setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, 0.1, nullptr, name));
    }
    ~Worldly() override { stopForGood(); }

private:
    void updateHook() override {
        if (++count_ > 2) return;
        last_ = std::chrono::system_clock::now().time_since_epoch().count();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        std::thread([] {}).join();
    }
    int count_ = 0;
    std::atomic<long long> last_{0};
};

/** Takes random numbers and opens devices. */
class Gambler : public RTT::TaskContext {
public:
    explicit Gambler(const std::string& name) : RTT::TaskContext(name) {}
    ~Gambler() override { stopForGood(); }

private:
    bool configureHook() override {
        for (const char* file : {"/dev/null", "/dev/ptmx"})
            if (const int opened = open(file, O_RDONLY | O_NOCTTY); opened >= 0) (void)close(opened);
        return true;
    }
    void updateHook() override {
        unsigned state = 1;
        sum_ += rand_r(&state) + rand();
        std::random_device device;
        sum_ += device();
        (void)getrandom(&state, sizeof state, 0);
        std::ifstream("/dev/urandom") >> state;
        std::mt19937 own(1);
        sum_ += own();
    }
    double sum_ = 0;
};

/** Is triggered by a thread of its own. */
class Messenger : public RTT::TaskContext {
public:
    explicit Messenger(const std::string& name) : RTT::TaskContext(name) {}
    ~Messenger() override { stopForGood(); }

private:
    void updateHook() override {
        if (++count_ > 2) return;
        std::thread([this] { trigger(); }).join();
    }
    int count_ = 0;
};

/** Waits within its first step for the next one of the ticker, up to 5.5 s. */
class Patient : public RTT::TaskContext {
public:
    explicit Patient(const std::string& name) : RTT::TaskContext(name) {
        setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, 0.1, nullptr, name));
    }
    ~Patient() override { stopForGood(); }

private:
    void updateHook() override {
        if (waited_) return;
        waited_ = true;
        const auto begun = RTT::os::TimeService::Instance()->getNSecs();
        (void)engine()->waitForMessages([begun] { return RTT::os::TimeService::Instance()->getNSecs() != begun; },
                                        rtos_get_time_ns() + 5500000000);
    }
    bool waited_ = false;
};

/** Has an activity of a class that the runtime does not know. */
class Loner : public RTT::TaskContext {
public:
    explicit Loner(const std::string& name) : RTT::TaskContext(name) {
        struct Own : RTT::Activity {
            Own() : RTT::Activity(ORO_SCHED_OTHER, 0, 0.0) {}
        };
        setActivity(new Own);
    }
    ~Loner() override { stopForGood(); }
};

}  // namespace replaytest

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(replaytest::Viewer)
ORO_LIST_COMPONENT_TYPE(replaytest::Ticker)
ORO_LIST_COMPONENT_TYPE(replaytest::Restless)
ORO_LIST_COMPONENT_TYPE(replaytest::Worldly)
ORO_LIST_COMPONENT_TYPE(replaytest::Messenger)
ORO_LIST_COMPONENT_TYPE(replaytest::Patient)
ORO_LIST_COMPONENT_TYPE(replaytest::Loner)
ORO_LIST_COMPONENT_TYPE(replaytest::Gambler)
