// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a log line costs the thread that writes it: when nobody sees it, and in a real-time thread.
#include "pairs.hpp"

#include <rtt/Logger.hpp>
#include <rtt/os/startstop.h>

#include <cstdlib>
#include <pthread.h>
#include <streambuf>

using namespace RTT;

namespace {

struct Nowhere : std::streambuf {
    std::streamsize xsputn(const char*, std::streamsize size) override { return size; }
    int_type overflow(int_type c) override { return traits_type::not_eof(c); }
};

/** The log of this process goes to a console that throws it away. */
void prepare() {
    static Nowhere nowhere;
    static std::ostream console(&nowhere);
    static const bool done = [] {
        setenv("ORO_LOGFILE", "/dev/null", 1);
        static char name[] = "log_bench";
        static char* arguments[] = {name, nullptr};
        __os_init(1, arguments);
        Logger::Instance()->setStdStream(console);
        Logger::Instance()->setLogLevel(Logger::Warning);
        return true;
    }();
    (void)done;
}

void hiddenLine(benchmark::State& state) {
    prepare();
    int i = 0;
    for (auto _ : state) log(Debug) << "value " << ++i << " of " << 1.5 << endlog();
}
BENCHMARK(hiddenLine)->Name("log/line that nobody sees");

bool setScheduler(int scheduler, int priority) {
    sched_param parameters{};
    parameters.sched_priority = priority;
    return pthread_setschedparam(pthread_self(), scheduler, &parameters) == 0;
}

void realTimeLine(benchmark::State& state) {
    prepare();
    constexpr int kLines = 100;  // fits into the queue
    std::vector<double> times;
    for (auto _ : state) {
        if (!setScheduler(SCHED_FIFO, 1)) return state.SkipWithError("this process may not have real-time threads");
        const double each = bench::timed(CLOCK_THREAD_CPUTIME_ID, [] {
            for (int i = 0; i < kLines; ++i) log(Error) << "value " << i << " of " << 1.5 << endlog();
        });
        setScheduler(SCHED_OTHER, 0);
        log(Error) << flushlog();
        times.push_back(each / kLines * 1e9);
        state.SetIterationTime(each / kLines);
    }
    state.counters["ns"] = bench::median(times);
}
BENCHMARK(realTimeLine)->Name("log/line of a real-time thread")->Iterations(bench::kPairs)->UseManualTime();

void ordinaryLine(benchmark::State& state) {
    prepare();
    int i = 0;
    for (auto _ : state) log(Error) << "value " << ++i << " of " << 1.5 << endlog();
}
BENCHMARK(ordinaryLine)->Name("log/line of an ordinary thread, without the console's own time");

}  // namespace
