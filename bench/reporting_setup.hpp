// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_BENCH_REPORTING_SETUP_HPP
#define OROFORGE_BENCH_REPORTING_SETUP_HPP

#include <rtt/Activity.hpp>
#include <rtt/Attribute.hpp>
#include <rtt/Logger.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/Property.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/os/startstop.h>

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace reporting_bench {

inline void startRuntime() {
    static const bool once = [] {
        RTT::Logger::Instance()->setLogLevel(RTT::Never);  // rows that come without pause may find no room
        static char name[] = "reporting_bench";
        static char* words[] = {name, nullptr};
        void* const library = dlopen(RTT_TYPEKIT_FILE, RTLD_NOW);
        if (__os_init(1, words) != 0 || !library) std::abort();
        return reinterpret_cast<bool (*)(void*)>(dlsym(library, "loadRTTPlugin"))(nullptr);
    }();
    if (!once) std::abort();
}

/** A component with that many ports, and a reporter of them. */
template <class Reporter>
class Setup {
public:
    Setup(long ports, const char* file) : file_(file) {
        startRuntime();
        for (long i = 0; i < ports; ++i) {
            ports_.push_back(std::make_unique<RTT::OutputPort<double>>("port" + std::to_string(i)));
            component_.addPort(*ports_.back());
        }
        reporter.addPeer(&component_);
        RTT::Property<std::string>(reporter.getProperty("ReportFile")).set(file_);
        if (!reporter.reportComponent("component")) std::abort();
    }
    ~Setup() { std::remove(file_); }

    void write() {
        value_ += 0.123456;
        for (const auto& port : ports_) port->write(value_);
    }
    unsigned lost() { return RTT::Attribute<unsigned>(reporter.getAttribute("LostRows")).get(); }

private:
    RTT::TaskContext component_{"component"};
    std::vector<std::unique_ptr<RTT::OutputPort<double>>> ports_;
    double value_ = 0;
    const char* const file_;

public:
    Reporter reporter{"reporter"};
};

/** For OROFORGE_BENCH_SECONDS (2) seconds, in threads of their own. */
template <class Reporter>
void atOneKilohertz(benchmark::State& state, const char* file, long (*rowsIn)(const char*)) {
    const char* const given = std::getenv("OROFORGE_BENCH_SECONDS");
    const int seconds = given ? std::atoi(given) : 2;
    for (auto _ : state) {
        Setup<Reporter> setup(state.range(0), file);
        RTT::Activity::Options options;
        options.name = "reporter";
        options.scheduler = ORO_SCHED_RT;
        options.priority = 80;
        options.period = 0.001;
        setup.reporter.setActivity(new RTT::Activity(options));
        if (!setup.reporter.start()) std::abort();
        const auto begin = std::chrono::steady_clock::now();
        for (int i = 0; i < seconds * 1000; ++i) {
            setup.write();
            std::this_thread::sleep_until(begin + std::chrono::milliseconds(i + 1));
        }
        setup.reporter.stop();
        state.counters["rows"] = static_cast<double>(rowsIn(file));
        state.counters["lost"] = setup.lost();
    }
}

}  // namespace reporting_bench

#endif
