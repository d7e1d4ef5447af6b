// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_RECORDED_TIMES_HPP
#define OROFORGE_TESTS_RECORDED_TIMES_HPP

#include <replay/player.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/os/TimeService.hpp>
#include <schedule/schedule.hpp>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace schedule_test {

constexpr RTT::nsecs kMs = 1000000;
constexpr RTT::nsecs kStart = 1700000000000000000;

/** Milliseconds since the start of the schedule. */
inline long now() { return static_cast<long>((RTT::os::TimeService::Instance()->getNSecs() - kStart) / kMs); }

/** Does something at given times. */
class Times : public OCL::replay::TimedSource {
public:
    /** Milliseconds since the start. */
    void at(long time, std::function<void()> what) { all_.emplace(kStart + time * kMs, std::move(what)); }
    void until(long time) {
        at(time, [] {});
    }
    std::optional<RTT::nsecs> next() override {
        return all_.empty() ? std::nullopt : std::optional<RTT::nsecs>(all_.begin()->first);
    }
    void deliver() override {
        const RTT::nsecs time = all_.begin()->first;
        while (!all_.empty() && all_.begin()->first == time) {
            all_.begin()->second();
            all_.erase(all_.begin());
        }
    }

private:
    std::multimap<RTT::nsecs, std::function<void()>> all_;
};

typedef std::vector<std::string> Events;

/** Notes each updateHook() with its time: "A@10". */
class Noting : public RTT::TaskContext {
public:
    Noting(const std::string& name, Events& events) : RTT::TaskContext(name), events_(events) {
        mTriggerOnStart = false;
    }
    ~Noting() override { stopForGood(); }
    std::function<void()> update;

protected:
    void updateHook() override {
        events_.push_back(getName() + "@" + std::to_string(now()));
        if (update) update();
    }

private:
    Events& events_;
};

inline bool never() { return false; }

}  // namespace schedule_test

#endif
