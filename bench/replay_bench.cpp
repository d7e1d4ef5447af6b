// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How many times faster than real time 50 components are executed in simulated time: half of them have a period of 1 ms,
// the others are woken by messages, one for each in a millisecond. `times` is the factor; the goal is 20. With a recorder
// of the 50000 messages that they send in a second, too: all of a millisecond at one time, or each at its own.
#include <replay/player.hpp>
#include <rtt/Activity.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/Logger.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/os/startstop.h>
#include <schedule/schedule.hpp>
#ifdef HAS_RECORDER
#include <ocl/McapReporting.hpp>
#include <rtt/Property.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#endif

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace {

constexpr int kPairs = 25;
constexpr RTT::nsecs kMillisecond = 1000000, kStart = 1700000000000000000;

/** The runtime, which says nothing. */
void prepare() {
    static const bool done = [] {
        setenv("ORO_LOGFILE", "/dev/null", 1);
        static char name[] = "replay_bench";
        static char* arguments[] = {name, nullptr};
        __os_init(1, arguments);
        RTT::Logger::Instance()->setLogLevel(RTT::Logger::Error);
#ifdef HAS_RECORDER
        return RTT::plugin::PluginLoader::Instance()->loadLibrary(RTT_TYPEKIT_FILE);
#else
        return true;
#endif
    }();
    (void)done;
}

/** Sends twice what it gets. */
class Doubling : public RTT::TaskContext {
public:
    Doubling(const std::string& name, double period) : RTT::TaskContext(name) {
        if (period > 0) {
            addPort("in", in);
            setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, period, nullptr, name));
        } else {
            addEventPort("in", in);
        }
        addPort("out", out);
    }
    ~Doubling() override { stopForGood(); }
    void updateHook() override {
        double value = 0;
        if (in.read(value) == RTT::NewData) out.write(2 * value);
    }
    RTT::InputPort<double> in;
    RTT::OutputPort<double> out;
};

/** A message for each port in each millisecond. */
class Messages : public OCL::replay::TimedSource {
public:
    /** @param apart the messages of a millisecond have times of their own. */
    Messages(std::vector<std::unique_ptr<RTT::OutputPort<double>>>& ports, long ms, bool apart)
        : ports_(ports), left_(ms), apart_(apart) {}
    std::optional<RTT::nsecs> next() override {
        if (left_ == 0) return std::nullopt;
        return time_ + static_cast<RTT::nsecs>(next_) * 1000;
    }
    void deliver() override {
        while (next_ != ports_.size()) {
            ports_[next_++]->write(1.0);
            if (apart_ && next_ != ports_.size()) return;
        }
        next_ = 0;
        time_ += kMillisecond;
        --left_;
    }

private:
    std::vector<std::unique_ptr<RTT::OutputPort<double>>>& ports_;
    RTT::nsecs time_ = kStart + kMillisecond;
    long left_;
    const bool apart_;
    std::size_t next_ = 0;
};

enum class Recorded { Not, Together, Apart };

#ifdef HAS_RECORDER
/** What --record of a replay is. */
class Recorder {
public:
    Recorder(const std::vector<std::unique_ptr<Doubling>>& components, OCL::schedule::Schedule& schedule) {
        set<std::string>("ReportFile", "/dev/null");
        set<std::string>("Clock", "component");
        set("Reproducible", true);
        for (const auto& component : components) {
            recorder_.addPeer(component.get());
            (void)recorder_.reportPort(component->getName(), "out");
        }
        schedule.executeLast(recorder_);
        good_ = recorder_.start();
    }
    bool good() const { return good_; }

private:
    template <class T>
    void set(const char* name, const T& value) {
        dynamic_cast<RTT::Property<T>&>(*recorder_.getProperty(name)).set(value);
    }
    OCL::McapReporting recorder_{"recorder"};
    bool good_ = false;
};
#endif

void fiftyComponents(benchmark::State& state, Recorded recorded) {
    prepare();
    constexpr long kSimulated = 2000;  // ms
    for (auto _ : state) {
        state.PauseTiming();
        OCL::schedule::Schedule schedule(kStart);
        std::vector<std::unique_ptr<RTT::OutputPort<double>>> ports;
        std::vector<std::unique_ptr<Doubling>> components;
        for (int i = 0; i != kPairs; ++i) {
            ports.push_back(std::make_unique<RTT::OutputPort<double>>("port"));
            components.push_back(std::make_unique<Doubling>("woken" + std::to_string(i), 0));
            ports.back()->connectTo(&components.back()->in);
            components.push_back(std::make_unique<Doubling>("periodic" + std::to_string(i), 0.001));
            components[components.size() - 2]->out.connectTo(&components.back()->in);
        }
        for (const auto& component : components) component->start();
#ifdef HAS_RECORDER
        std::optional<Recorder> recorder;
        if (recorded != Recorded::Not && !recorder.emplace(components, schedule).good())
            return state.SkipWithError("the recorder does not start");
#endif
        Messages messages(ports, kSimulated, recorded == Recorded::Apart);
        state.ResumeTiming();
        const auto outcome = schedule.run(messages, [] { return false; });
        benchmark::DoNotOptimize(outcome.executions);
        state.PauseTiming();
#ifdef HAS_RECORDER
        recorder.reset();
#endif
        components.clear();
        state.ResumeTiming();
    }
    state.counters["times"] =
        benchmark::Counter(static_cast<double>(state.iterations()) * kSimulated / 1000, benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(fiftyComponents, notRecorded, Recorded::Not)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
#ifdef HAS_RECORDER
BENCHMARK_CAPTURE(fiftyComponents, recorded, Recorded::Together)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(fiftyComponents, recordedApart, Recorded::Apart)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
#endif

}  // namespace
