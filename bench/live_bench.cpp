// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What it costs a component to be watched through the live window. The clients are other processes.
#include "pairs.hpp"

#include <live/door/door.hpp>
#include <live/door/module.hpp>
#include <live_server/raw_client.hpp>
#include <rtt/Activity.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/os/startstop.h>
#include <rtt/plugin/PluginLoader.hpp>
#include <support/temp_dir.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <vector>

namespace {

constexpr double kPeriod = 0.001;
/** Times of write(), compared with those that nobody watches. */
constexpr double kOfAll = 1.6, kOfTimes = 2.2;

/** Writes all its ports every millisecond, and keeps how late it was. */
class Source : public RTT::TaskContext {
public:
    explicit Source(unsigned ports) : TaskContext("Source") {
        lateness.reserve(100000);
        for (unsigned i = 0; i != ports; ++i) {
            outputs.push_back(std::make_unique<RTT::OutputPort<double>>("number" + std::to_string(i)));
            addPort(*outputs.back());
        }
        setActivity(new RTT::Activity(ORO_SCHED_RT, 80, kPeriod, nullptr, "Source"));
    }
    ~Source() override { stopForGood(); }

    bool startHook() override {
        lateness.clear();
        return true;
    }
    void updateHook() override {
        const double now = bench::seconds(CLOCK_MONOTONIC);
        if (lateness.empty()) due_ = now;
        if (lateness.size() < lateness.capacity()) lateness.push_back(now - due_);
        due_ += kPeriod;
        for (auto& output : outputs) output->write(now);
    }
    /** Above the earliest cycle. */
    double latenessOf(double part) {
        std::sort(lateness.begin(), lateness.end());
        return lateness.empty() ? 0
                                : lateness[static_cast<std::size_t>(part * double(lateness.size() - 1))] - lateness[0];
    }

    std::vector<double> lateness;
    std::vector<std::unique_ptr<RTT::OutputPort<double>>> outputs;

private:
    double due_ = 0;
};

/** A deployment of one component, and its live window. */
class Deployment {
public:
    explicit Deployment(unsigned ports) : source(ports) {
        OCL::live::SocketFolder::Fault fault;
        folder_ = std::make_unique<OCL::live::SocketFolder>(directory_ / "live", fault);
        std::string error;
        socket_ = std::make_unique<OCL::live::DoorSocket>(*folder_, "bench.sock", error);
        deployer_.addPeer(&source);
        OCL::live::ServerStart how;
        how.deployer = &deployer_;
        how.name = "Deployer";
        how.stop = [] {};
        how.local = ::dup(socket_->get());
        server_.reset(oroLiveServe(how, error));
        if (!server_) std::abort();
    }
    std::string path() const { return folder_->path() + "/bench.sock"; }

    Source source;

private:
    oroforge::test::TempDir directory_;
    RTT::TaskContext deployer_{"Deployer"};
    std::unique_ptr<OCL::live::SocketFolder> folder_;
    std::unique_ptr<OCL::live::DoorSocket> socket_;
    std::unique_ptr<OCL::live::RunningServer> server_;
};

/** A process that watches the first ports of the source, until it is destroyed. */
class Client {
public:
    /** `how`: further fields of its requests; without any it gets all samples, as JSON. */
    Client(const std::string& path, unsigned ports, const nlohmann::json& how = nlohmann::json::object())
        : process_(fork()) {
        if (process_ == 0) watch(path, ports, how);
        // Until it has subscribed.
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
    }
    Client(const Client&) = delete;
    ~Client() {
        kill(process_, SIGKILL);
        waitpid(process_, nullptr, 0);
    }
    void freeze() const { kill(process_, SIGSTOP); }

private:
    [[noreturn]] static void watch(const std::string& path, unsigned ports, const nlohmann::json& how) {
        auto client = live_test::RawClient::unixSocket(path);
        if (!client.open()) _exit(1);
        for (unsigned i = 0; i != ports; ++i) {
            nlohmann::json wanted = {{"op", "oro.watch"}, {"id", i}, {"port", "Source.number" + std::to_string(i)}};
            wanted.update(how);
            if (!client.say(wanted)) _exit(1);
        }
        while (!client.all(1000).empty()) {
        }
        _exit(0);
    }
    pid_t process_;
};

void pause() { std::this_thread::sleep_for(std::chrono::seconds(2)); }

/** How late a component of 1 kHz is when four clients watch it, one of them stopped, against the same component without
    clients. */
void latenessWatchedByFour(benchmark::State& state) {
    Deployment deployment(1);
    const auto lateness = [&] {
        deployment.source.start();
        pause();
        deployment.source.stop();
        return deployment.source.latenessOf(0.99);
    };
    bench::inPairs(
        state, 1.1,
        [&] {
            const Client one(deployment.path(), 1), two(deployment.path(), 1), three(deployment.path(), 1),
                frozen(deployment.path(), 1);
            frozen.freeze();
            return lateness();
        },
        lateness);
}
BENCHMARK(latenessWatchedByFour)->Iterations(11)->UseManualTime()->Unit(benchmark::kMicrosecond);

/** What a watch costs write(), of a port that has a connection. A hundred samples, then time for the client: the buffer
    of the watch does not get full. */
void writeWatched(benchmark::State& state, double target, const nlohmann::json& how) {
    Deployment deployment(2);
    RTT::OutputPort<double>&watched = *deployment.source.outputs[0], &other = *deployment.source.outputs[1];
    RTT::InputPort<double> readers[2] = {{"a"}, {"b"}};
    watched.connectTo(&readers[0]);
    other.connectTo(&readers[1]);
    const Client client(deployment.path(), 1, how);
    const auto write = [](RTT::OutputPort<double>& port) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        constexpr int count = 100;
        return bench::timed(CLOCK_THREAD_CPUTIME_ID,
                            [&] {
                                for (int i = 0; i != count; ++i) port.write(i);
                            }) /
               count;
    };
    bench::inPairs(
        state, target, [&] { return write(watched); }, [&] { return write(other); });
}
/** By one that wants the newest sample, one that wants all, and a recorder, which wants their times, too. */
void writeDrawn(benchmark::State& state) { writeWatched(state, 1.3, {{"rate", 60}}); }
void writeFollowed(benchmark::State& state) { writeWatched(state, kOfAll, nlohmann::json::object()); }
void writeRecorded(benchmark::State& state) { writeWatched(state, kOfTimes, {{"format", "cdr"}, {"times", true}}); }
BENCHMARK(writeDrawn)->Iterations(bench::kPairs)->UseManualTime()->Unit(benchmark::kNanosecond);
BENCHMARK(writeFollowed)->Iterations(bench::kPairs)->UseManualTime()->Unit(benchmark::kNanosecond);
BENCHMARK(writeRecorded)->Iterations(bench::kPairs)->UseManualTime()->Unit(benchmark::kNanosecond);

/** Part of a processor that the server takes for a client that draws 200 ports of 1 kHz. */
void twoHundredPorts(benchmark::State& state) {
    Deployment deployment(200);
    deployment.source.start();
    const auto load = [] { return bench::timed(CLOCK_PROCESS_CPUTIME_ID, pause) / 2; };
    std::vector<double> parts;
    for (auto _ : state) {
        const double alone = load();
        const Client client(deployment.path(), 200, {{"rate", 60}});
        parts.push_back(load() - alone);
        state.SetIterationTime(parts.back());
    }
    state.counters["ratio"] = bench::median(parts);
    state.counters["target_ratio"] = 0.06;
}
BENCHMARK(twoHundredPorts)->Iterations(5)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
    __os_init(0, nullptr);
    if (!RTT::plugin::PluginLoader::Instance()->loadLibrary(RTT_TYPEKIT_FILE)) return 1;
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
