// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Topics of ports against those of roscpp itself: a message of 64 bytes there and back between two processes, and what a
// topic costs the thread that writes.
#include "pairs.hpp"

#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/os/Semaphore.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt_roscomm/message_table.hpp>
#include <rtt_roscomm/rostopic.h>
#include <std_msgs/Float64.h>
#include <std_msgs/String.h>
#include <support/ros_master.hpp>

#include <csignal>
#include <ctime>
#include <memory>
#include <string>

#include <sys/prctl.h>
#include <unistd.h>

namespace {

using namespace RTT;

constexpr int kRoundTrips = 300;
constexpr int kWrites = 20000;

template <class Message>
rtt_roscomm::MessageEntry entry(const char* type) {
    namespace traits = ros::message_traits;
    return {type, traits::datatype<Message>(), traits::md5sum<Message>(), traits::definition<Message>()};
}

void beNode(const char* name) {
    plugin::PluginLoader::Instance()->loadTypekit("rtt-typekit");
    static const rtt_roscomm::MessageEntry table[] = {entry<std_msgs::Float64>("double"),
                                                      entry<std_msgs::String>("string")};
    types::TypekitRepository::Import(new rtt_roscomm::MessageTransport("bench", table, std::size(table)));
    ros::init(ros::M_string(), name, ros::init_options::NoSigintHandler | ros::init_options::NoRosout);
    ros::start();
    static ros::AsyncSpinner spinner(1);
    spinner.start();
}

/** A component that is executed by the thread that brings the sample. */
class Player : public TaskContext {
public:
    Player(const std::string& name, bool answers) : TaskContext(name), answers_(answers) {
        addPort("out", out);
        addEventPort("in", in);
        setActivity(new extras::SequentialActivity());
        start();
    }
    bool connect(const std::string& to, const std::string& from) {
        return out.createStream(rtt_roscomm::topic(to)) && in.createStream(rtt_roscomm::topic(from));
    }
    void updateHook() override {
        if (in.read(text_) != NewData) return;
        if (answers_)
            out.write(text_);
        else
            arrived.signal();
    }
    OutputPort<std::string> out;
    InputPort<std::string> in;
    os::Semaphore arrived{0};

private:
    const bool answers_;
    std::string text_;
};

struct Plain {
    explicit Plain(bool answers, const std::string& to, const std::string& from)
        : publisher(handle.advertise<std_msgs::String>(to, 1)),
          subscriber(handle.subscribe<std_msgs::String>(
              from, 1,
              [this, answers](const std_msgs::String::ConstPtr& message) {
                  if (answers)
                      publisher.publish(message);
                  else
                      arrived.signal();
              },
              {}, ros::TransportHints().tcpNoDelay())) {}
    ros::NodeHandle handle;
    os::Semaphore arrived{0};
    ros::Publisher publisher;
    ros::Subscriber subscriber;
};

/** The master, and a process that answers. That one is made before this one has threads. */
class World {
public:
    static World& instance() {
        static World one;
        return one;
    }
    bool isReady() {
        for (int i = 0; i != 1000; ++i) {
            if (plain_->publisher.getNumSubscribers() != 0 && plain_->subscriber.getNumPublishers() != 0) {
                player_->out.write("ready?");
                usleep(10000);
                if (player_->arrived.trywait()) return true;
            }
            usleep(10000);
        }
        return false;
    }
    /** Seconds for one. */
    double rally() {
        const std::string text(60, 'x');
        const double begin = bench::seconds(CLOCK_MONOTONIC);
        for (int i = 0; i != kRoundTrips; ++i) {
            player_->out.write(text);
            player_->arrived.wait();
        }
        return (bench::seconds(CLOCK_MONOTONIC) - begin) / kRoundTrips;
    }
    double plainRally() {
        std_msgs::String message;
        message.data.assign(60, 'x');
        const double begin = bench::seconds(CLOCK_MONOTONIC);
        for (int i = 0; i != kRoundTrips; ++i) {
            plain_->publisher.publish(message);
            plain_->arrived.wait();
        }
        return (bench::seconds(CLOCK_MONOTONIC) - begin) / kRoundTrips;
    }

private:
    World() {
        child_ = fork();
        if (child_ == 0) {
            (void)prctl(PR_SET_PDEATHSIG, SIGKILL);
            beNode("answerer");
            const Plain plain(true, "/plain_back", "/plain_there");
            Player player("answerer", true);
            if (player.connect("/back", "/there")) pause();
            _exit(1);
        }
        beNode("asker");
        plain_ = std::make_unique<Plain>(false, "/plain_there", "/plain_back");
        player_ = std::make_unique<Player>("asker", false);
        (void)player_->connect("/there", "/back");
    }
    ~World() {
        kill(child_, SIGKILL);
        player_.reset();
        plain_.reset();
        ros::shutdown();
    }
    oroforge::test::RosMaster master_;
    pid_t child_ = 0;
    std::unique_ptr<Plain> plain_;
    std::unique_ptr<Player> player_;
};

void roundTrip(benchmark::State& state) {
    World& world = World::instance();
    if (!world.isReady()) return state.SkipWithError("no streams");
    bench::inPairs(
        state, 1.2, [&] { return world.rally(); }, [&] { return world.plainRally(); });
}
BENCHMARK(roundTrip)
    ->Name("ros/round trip of 64 bytes between two processes against roscpp")
    ->Iterations(bench::kPairs)
    ->UseManualTime();

void write(benchmark::State& state) {
    (void)World::instance();
    OutputPort<double> out("out");
    TaskContext owner("owner");
    owner.addPort(out);
    if (!out.createStream(rtt_roscomm::topic("/written"))) return state.SkipWithError("no stream");
    for (auto _ : state) {
        const double taken = bench::timed(CLOCK_THREAD_CPUTIME_ID, [&] {
            for (int i = 0; i != kWrites; ++i) out.write(i);
        });
        state.SetIterationTime(taken / kWrites);
    }
    state.counters["target_ns"] = 60;
}
BENCHMARK(write)->Name("ros/write of a double to a topic")->Iterations(100)->UseManualTime();

}  // namespace
