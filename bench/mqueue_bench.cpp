// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A double there and back between two processes through message queues: ports, against plain mq_send() and mq_receive().
// In both, the thread that receives answers, with the same scheduling.
#include "pairs.hpp"
#include "rally_player.hpp"

#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/transports/mqueue/MQLib.hpp>
#include <rtt/types/Types.hpp>

#include <csignal>
#include <ctime>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <mqueue.h>
#include <sched.h>
#include <unistd.h>

namespace {

using namespace RTT;
using bench::kRoundTrips;

std::string queue(const char* what) {
    static const std::string own = "/oroforge_bench_" + std::to_string(getpid()) + '_';  // first used by the parent
    return own + what;
}

class Player : public bench::RallyPlayer {
public:
    explicit Player(const std::string& name) : RallyPlayer(name) {
        setActivity(new extras::SequentialActivity());
        start();
    }
    bool send(const std::string& name) { return out.createStream(policyOf(name)); }
    bool receive(const std::string& name) {
        for (int i = 0; i != 20; ++i)
            if (in.createStream(policyOf(name))) return true;
        return false;
    }

private:
    static ConnPolicy policyOf(const std::string& name) {
        if (!types::Types()->type("double")) plugin::PluginLoader::Instance()->loadTypekit("rtt-typekit");
        ConnPolicy policy = ConnPolicy::data();
        policy.transport = ORO_MQUEUE_PROTOCOL_ID;
        policy.name_id = name;
        return policy;
    }
};

struct PlainQueue {
    explicit PlainQueue(const std::string& name) {
        mq_attr attributes{};
        attributes.mq_maxmsg = 10;
        attributes.mq_msgsize = sizeof(double);
        opened = mq_open(name.c_str(), O_RDWR | O_CREAT, 0600, &attributes);
    }
    void send(double sample) const { (void)mq_send(opened, reinterpret_cast<char*>(&sample), sizeof sample, 0); }
    double receive() const {
        double sample = 0;
        (void)mq_receive(opened, reinterpret_cast<char*>(&sample), sizeof sample, nullptr);
        return sample;
    }
    mqd_t opened;
};

/** As the runtime's thread that receives; without the privilege both have the normal one. */
void runAsReceiver() {
    sched_param priority{};
    priority.sched_priority = sched_get_priority_max(SCHED_FIFO);
    (void)sched_setscheduler(0, SCHED_FIFO, &priority);
}

/** The processes that answer. Made before this one has threads. */
class Answerers {
public:
    Answerers() {
        (void)queue("");
        children_.push_back(start([] {
            runAsReceiver();
            const PlainQueue there(queue("there")), back(queue("back"));
            for (;;) back.send(there.receive());
        }));
        children_.push_back(start([] {
            Player player("answerer");
            if (player.send(queue("ports_back")) && player.receive(queue("ports_there"))) pause();
        }));
    }
    ~Answerers() {
        for (const pid_t child : children_) kill(child, SIGKILL);
        for (const char* name : {"there", "back", "ports_back"}) mq_unlink(queue(name).c_str());
    }

private:
    template <class Run>
    static pid_t start(Run run) {
        const pid_t child = fork();
        if (child == 0) {
            run();
            _exit(0);
        }
        return child;
    }
    std::vector<pid_t> children_;
};

double plainRally() {
    static const PlainQueue there(queue("there")), back(queue("back"));
    double result = 0;
    std::thread([&] {
        runAsReceiver();
        const double begin = bench::seconds(CLOCK_MONOTONIC);
        for (int i = 0; i != kRoundTrips; ++i) {
            there.send(1.0);
            (void)back.receive();
        }
        result = (bench::seconds(CLOCK_MONOTONIC) - begin) / kRoundTrips;
    }).join();
    return result;
}

void roundTrip(benchmark::State& state) {
    static const Answerers answerers;
    Player player("player");
    if (!player.send(queue("ports_there")) || !player.receive(queue("ports_back")))
        return state.SkipWithError("no streams");
    bench::inPairs(
        state, 1.3, [&] { return player.rally(); }, [] { return plainRally(); });
}
BENCHMARK(roundTrip)
    ->Name("mqueue/round trip of two processes against mq_send() and mq_receive()")
    ->Iterations(bench::kPairs)
    ->UseManualTime();

}  // namespace
