// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a message to a category costs the real-time thread that logs it: below the level, to an appender, and with eight
// threads at once.
#include "pairs.hpp"

#include <ocl/Category.hpp>
#include <ocl/LoggingService.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/Property.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/os/startstop.h>
#include <rtt/os/tlsf/tlsf.h>

#include <atomic>
#include <cstdlib>
#include <mutex>
#include <pthread.h>
#include <thread>
#include <vector>

using log4cpp::Priority;
using OCL::logging::Category;
using OCL::logging::LoggingEvent;

namespace {

constexpr int kMessages = 100;  // of each thread; all of them fit into the buffer
constexpr int kBlocks = 50;
constexpr int kThreads = 8;

/** Takes the events when the threads are done. */
class Sink : public RTT::TaskContext {
public:
    Sink() : RTT::TaskContext("sink") { addPort("LogPort", port); }
    void empty() {
        LoggingEvent event;
        while (port.read(event, false) == RTT::NewData) continue;
    }
    RTT::InputPort<LoggingEvent> port{"LogPort"};
};

struct Setup {
    Setup() {
        setenv("ORO_LOGFILE", "/dev/null", 1);
        static std::vector<char> memory(64 << 20);
        init_memory_pool(memory.size(), memory.data());
        __os_init(0, nullptr);
        Category::installFactory();
        for (int t = 0; t < kThreads; ++t) connect("bench." + std::to_string(t), kMessages);
        connect("bench.shared", kMessages * kThreads);
    }
    void connect(const std::string& name, int size) {
        OCL::logging::LoggingService& service = *new OCL::logging::LoggingService("service");
        static_cast<RTT::Property<int>*>(service.getProperty("BufferSize"))->set(size);
        static_cast<RTT::Property<RTT::PropertyBag>*>(service.getProperty("Appenders"))
            ->value()
            .ownProperty(new RTT::Property<std::string>(name, "", "sink"));
        service.addPeer(&sink);
        service.configure();
        categories.push_back(dynamic_cast<Category*>(log4cpp::Category::exists(name)));
    }
    Sink& sink = *new Sink;
    std::vector<Category*> categories;
};

Setup& setup() {
    static Setup& made = *new Setup;
    return made;
}

bool becomeRealTime() {
    sched_param parameters{};
    parameters.sched_priority = 1;
    return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
}

class Barrier {
public:
    explicit Barrier(int threads) { pthread_barrier_init(&barrier_, nullptr, static_cast<unsigned>(threads)); }
    ~Barrier() { pthread_barrier_destroy(&barrier_); }
    void wait() { pthread_barrier_wait(&barrier_); }

private:
    pthread_barrier_t barrier_;
};

/** Seconds that one of these many threads computes for a message, the median of all blocks of all threads. Zero if there
    are no real-time threads. */
template <class Log>
double inThreads(int count, bool own, Log log) {
    std::vector<double> times(static_cast<std::size_t>(count * kBlocks));
    std::atomic<int> refused{0};
    Barrier barrier(count);
    std::vector<std::thread> threads;
    for (int t = 0; t < count; ++t)
        threads.emplace_back([&, t] {
            Category& to = *setup().categories[static_cast<std::size_t>(own ? t : kThreads)];
            if (!becomeRealTime()) ++refused;
            for (int block = 0; block < kBlocks; ++block) {
                barrier.wait();
                if (t == 0) setup().sink.empty();
                barrier.wait();
                times[static_cast<std::size_t>(t * kBlocks + block)] =
                    bench::timed(CLOCK_THREAD_CPUTIME_ID,
                                 [&] {
                                     for (int i = 0; i < kMessages; ++i) log(to);
                                 }) /
                    kMessages;
            }
        });
    for (std::thread& thread : threads) thread.join();
    setup().sink.empty();
    return refused ? 0 : bench::median(times);
}

template <class Log>
void measure(benchmark::State& state, int threads, bool own, Log log) {
    setup();
    std::vector<double> times;
    for (auto _ : state) {
        const double each = inThreads(threads, own, log);
        if (each == 0) return state.SkipWithError("this process may not have real-time threads");
        times.push_back(each * 1e9);
        state.SetIterationTime(each);
    }
    state.counters["ns"] = bench::median(times);
}

const auto number = [](Category& to) { to.getRTStream(Priority::INFO) << "value " << 42; };
const auto text = [](Category& to) { to.info("a message of a few words"); };
const auto hidden = [](Category& to) { to.debug("a message of a few words"); };

#define CATEGORY_BENCH(name, threads, own, log)                      \
    BENCHMARK_CAPTURE(measure, log##threads##own, threads, own, log) \
        ->Name(name)                                                 \
        ->Iterations(bench::kPairs)                                  \
        ->UseManualTime()
CATEGORY_BENCH("category/number, one thread", 1, true, number);
CATEGORY_BENCH("category/number, eight threads with a category each", 8, true, number);
CATEGORY_BENCH("category/number, eight threads and one category", 8, false, number);
CATEGORY_BENCH("category/text, one thread", 1, true, text);
CATEGORY_BENCH("category/text below the level", 1, true, hidden);

}  // namespace
