// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Between threads: two components that answer each other's samples, and how late a periodic activity wakes up. The floors
// do the same with nothing but the system calls.
#include "futex_floor.hpp"
#include "pairs.hpp"
#include "rally_player.hpp"

#include <rtt/Activity.hpp>

#include <atomic>
#include <cstdint>
#include <ctime>
#include <pthread.h>
#include <sched.h>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

using namespace RTT;
using bench::futexPingPong;
using bench::futexSet;
using bench::futexWait;
using bench::Placement;

namespace {

// --- round trip ---

struct Player : bench::RallyPlayer {
    Player(const std::string& name, unsigned cpu) : RallyPlayer(name) {
        if (cpu != 0) getActivity()->setCpuAffinity(cpu);
        start();
    }
};

void roundTrip(benchmark::State& state, Placement where) {
    if (where.second > 1 && std::thread::hardware_concurrency() < 2) return state.SkipWithError("needs two CPUs");
    Player a("a", where.first), b("b", where.second);
    if (!a.out.createConnection(b.in) || !b.out.createConnection(a.in)) return state.SkipWithError("not connected");
    bench::inPairs(
        state, 1.25, [&] { return a.rally(); }, [&] { return futexPingPong(where); });
}
BENCHMARK_CAPTURE(roundTrip, free, Placement{0, 0})
    ->Name("event port/round trip of two threads against futex ping-pong")
    ->Iterations(bench::kPairs)
    ->UseManualTime();
BENCHMARK_CAPTURE(roundTrip, apart, Placement{1, 2})
    ->Name("event port/the same, each on its own CPU")
    ->Iterations(bench::kPairs)
    ->UseManualTime();
BENCHMARK_CAPTURE(roundTrip, together, Placement{1, 1})
    ->Name("event port/the same, both on one CPU")
    ->Iterations(bench::kPairs)
    ->UseManualTime();

// --- lateness ---

constexpr std::int64_t kPeriod = 1000000;  // ns
constexpr int kPeriods = 400;
constexpr int kPriority = 70;

std::int64_t now() {
    timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec * 1000000000LL + t.tv_nsec;
}

/** Wakes once per period from when it was started; knows how late each time was. */
class Lateness {
public:
    void begin() {
        late_.clear();
        begin_ = now();
    }
    bool wokeUp() {
        late_.push_back(static_cast<double>(now() - begin_ - kPeriod * static_cast<std::int64_t>(late_.size() + 1)));
        return late_.size() < kPeriods;
    }
    double percentile99() {  // in seconds
        std::sort(late_.begin(), late_.end());
        return late_[late_.size() * 99 / 100] * 1e-9;
    }
    Lateness() { late_.reserve(kPeriods + 1); }

private:
    std::vector<double> late_;
    std::int64_t begin_ = 0;
};

class Periodic : public Activity {
public:
    Periodic() : Activity(ORO_SCHED_RT, kPriority, kPeriod * 1e-9, nullptr, "lateness") { setMaxOverrun(-1); }
    ~Periodic() override { stop(); }
    double percentile99() {
        done_ = 0;
        start();
        futexWait(done_, 0);
        stop();
        return lateness_.percentile99();
    }

protected:
    // The first period begins where the activity does its work of the start.
    void work(base::RunnableInterface::WorkReason reason) override {
        if (reason == base::RunnableInterface::Trigger) lateness_.begin();
    }
    void step() override {
        if (done_ == 0 && !lateness_.wokeUp()) futexSet(done_, 1);
    }

private:
    Lateness lateness_;
    std::atomic<std::uint32_t> done_{1};
};

double sleepLoop(bool fifo) {
    Lateness lateness;
    std::thread thread([&] {
        sched_param priority{};
        priority.sched_priority = kPriority;
        if (fifo) pthread_setschedparam(pthread_self(), SCHED_FIFO, &priority);
        lateness.begin();
        std::int64_t wakeUp = now();
        do {
            wakeUp += kPeriod;
            const timespec until{wakeUp / 1000000000, wakeUp % 1000000000};
            clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
        } while (lateness.wokeUp());
    });
    thread.join();
    return lateness.percentile99();
}

void periodicLateness(benchmark::State& state) {
    Periodic activity;
    const bool fifo = activity.getScheduler() == ORO_SCHED_RT;
    bench::inPairs(
        state, 1.25, [&] { return activity.percentile99(); }, [&] { return sleepLoop(fifo); });
    if (!fifo) state.SetLabel("without SCHED_FIFO: no right to use it");
}
BENCHMARK(periodicLateness)
    ->Name("activity/1 kHz SCHED_FIFO, lateness p99 against clock_nanosleep")
    ->Iterations(15)
    ->UseManualTime();

}  // namespace
