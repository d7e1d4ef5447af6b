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
#include <iostream>
#include <thread>

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
