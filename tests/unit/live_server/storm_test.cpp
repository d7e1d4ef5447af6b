// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The server in this process: clients watch while components come and go.
#include "raw_client.hpp"

#include <live/door/door.hpp>
#include <live/door/module.hpp>
#include <live/door/unix_address.hpp>
#include <rtt/Activity.hpp>
#include <rtt/Logger.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/os/startstop.h>
#include <rtt/plugin/PluginLoader.hpp>
#include <support/temp_dir.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <chrono>
#include <cstdint>
#include <memory>
#include <random>
#include <thread>
#include <vector>

namespace {

using live_test::RawClient;
using nlohmann::json;

class Source : public RTT::TaskContext {
public:
    explicit Source(const std::string& name) : TaskContext(name) {
        addPort("number", number);
        addPort("texts", texts);
        addProperty("gain", gain);
    }
    ~Source() override { stopForGood(); }
    void updateHook() override {
        number.write(++count);
        texts.write("sample " + std::to_string(int(count)));
    }
    double gain = 1, count = 0;
    RTT::OutputPort<double> number;
    RTT::OutputPort<std::string> texts;
};

class LiveServer : public testing::Test {
protected:
    LiveServer() {
        static const bool begun = [] {
            __os_init(0, nullptr);
            return RTT::plugin::PluginLoader::Instance()->loadLibrary(RTT_TYPEKIT_FILE);
        }();
        EXPECT_TRUE(begun);
        OCL::live::SocketFolder::Fault fault;
        folder = std::make_unique<OCL::live::SocketFolder>(directory / "live", fault);
        std::string error;
        socket = std::make_unique<OCL::live::DoorSocket>(*folder, "test.sock", error);
        EXPECT_TRUE(*socket) << error;
        start();
    }
    ~LiveServer() override { server.reset(); }

    void start() {
        OCL::live::ServerStart how;
        how.deployer = &deployer;
        how.name = "Deployer";
        how.stop = [this] { stopped = true; };
        how.local = ::dup(socket->get());
        std::string error;
        server.reset(oroLiveServe(how, error));
        ASSERT_TRUE(server) << error;
    }
    std::unique_ptr<Source> makeSource(const std::string& name) {
        auto source = std::make_unique<Source>(name);
        source->setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, 0.001, nullptr, name));
        deployer.addPeer(source.get());
        source->configure();
        source->start();
        return source;
    }
    RawClient client() const { return RawClient::unixSocket(folder->path() + "/test.sock"); }

    oroforge::test::TempDir directory;
    RTT::TaskContext deployer{"Deployer"};
    std::unique_ptr<OCL::live::SocketFolder> folder;
    std::unique_ptr<OCL::live::DoorSocket> socket;
    std::unique_ptr<OCL::live::RunningServer> server;
    std::atomic<bool> stopped{false};
};

TEST_F(LiveServer, EverySampleOfAPortArrivesInOrder) {
    const auto source = makeSource("Source");
    RawClient one = client();
    ASSERT_TRUE(one.open());
    ASSERT_TRUE(one.say({{"op", "oro.watch"}, {"id", "w"}, {"port", "Source.number"}}));
    EXPECT_EQ("double", one.hear("oro.answer")["result"].value("type", ""));
    // The first sample is the last one from before the watch; what is written while the port is being connected is lost.
    one.hear("oro.sample");
    double last = 0;
    for (int i = 0; i < 200; ++i) {
        const json sample = one.hear("oro.sample");
        ASSERT_EQ("w", sample.value("id", "")) << sample;
        const double value = sample["value"];
        if (last != 0 && sample["dropped"] == 0) {
            EXPECT_EQ(last + 1, value);
        }
        last = value;
    }
    ASSERT_TRUE(one.say({{"op", "oro.unwatch"}, {"id", 2}, {"watch", "w"}}));
    EXPECT_EQ(2, one.hear("oro.answer").value("id", 0));
    EXPECT_FALSE(source->number.connected());
}

TEST_F(LiveServer, ARateGivesFewerSamplesWithoutDrops) {
    const auto source = makeSource("Source");
    RawClient one = client();
    ASSERT_TRUE(one.open());
    ASSERT_TRUE(one.say({{"op", "oro.watch"}, {"id", 1}, {"port", "Source.number"}, {"rate", 20}}));
    json first = one.hear("oro.sample"), last;
    for (int i = 0; i < 5; ++i) last = one.hear("oro.sample");
    EXPECT_EQ(0, last.value("dropped", -1));
    const double seconds = (last.value("time", 0.0) - first.value("time", 0.0)) / 1e9;
    EXPECT_GT(seconds, 0.15);
}

TEST_F(LiveServer, AWatchOfTheNewestSampleIsNoConnection) {
    RTT::TaskContext quiet("Quiet");
    RTT::OutputPort<double> keeps("keeps"), forgets("forgets", false);
    RTT::OutputPort<std::string> text("text");
    for (RTT::base::OutputPortInterface* port :
         {static_cast<RTT::base::OutputPortInterface*>(&keeps), static_cast<RTT::base::OutputPortInterface*>(&forgets),
          static_cast<RTT::base::OutputPortInterface*>(&text)})
        quiet.addPort(*port);
    deployer.addPeer(&quiet);
    keeps.write(1);
    text.write("one");
    RawClient one = client();
    ASSERT_TRUE(one.open());
    const auto watch = [&](int id, const char* port) {
        EXPECT_TRUE(one.say({{"op", "oro.watch"}, {"id", id}, {"port", port}, {"rate", 1000}}));
        EXPECT_EQ(id, one.hear("oro.answer").value("id", 0));
    };
    watch(1, "Quiet.keeps");
    EXPECT_EQ(1.0, one.hear("oro.sample")["value"]);
    watch(2, "Quiet.text");
    EXPECT_EQ("one", one.hear("oro.sample")["value"]);
    watch(3, "Quiet.forgets");
    EXPECT_EQ((std::vector<bool>{false, false, true}),
              (std::vector<bool>{keeps.connected(), text.connected(), forgets.connected()}));
    // A sample is new even if its value is not.
    for (int i = 0; i != 3; ++i) {
        keeps.write(2);
        EXPECT_EQ(2.0, one.hear("oro.sample")["value"]);
        text.write("two");
        EXPECT_EQ("two", one.hear("oro.sample")["value"]);
    }
    forgets.write(3);
    EXPECT_EQ(3, one.hear("oro.sample")["id"]);
    keeps.keepLastWrittenValue(false);
    const json ended = one.hear("oro.error");
    EXPECT_EQ(1, ended["id"]);
    EXPECT_EQ("LIV008", ended["code"]);
    watch(4, "Quiet.keeps");
    EXPECT_TRUE(keeps.connected());
}

TEST_F(LiveServer, ARecorderGetsTheTimesOfWriting) {
    RTT::TaskContext quiet("Quiet");
    RTT::OutputPort<double> number("number");
    RTT::OutputPort<std::string> text("text");
    quiet.addPort(number);
    quiet.addPort(text);
    deployer.addPeer(&quiet);
    const auto now = [] {
        return std::int64_t(std::chrono::system_clock::now().time_since_epoch() / std::chrono::nanoseconds(1));
    };
    number.write(-1);
    text.write("first");
    for (const char* port : {"Quiet.number", "Quiet.text"}) {
        RawClient one = client();
        ASSERT_TRUE(one.open());
        const std::int64_t begin = now();
        ASSERT_TRUE(one.say({{"op", "oro.watch"}, {"id", 1}, {"port", port}, {"times", true}}));
        EXPECT_EQ(1, one.hear("oro.answer").value("id", 0));
        // The sample from before has the time at which the watch began.
        std::vector<std::int64_t> before{begin}, after{now()};
        for (int i = 0; i != 50; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            before.push_back(now());
            number.write(i);
            text.write("number " + std::to_string(i));
            after.push_back(now());
        }
        for (std::size_t i = 0; i != before.size(); ++i) {
            const auto time = one.hear("oro.sample").value("time", std::int64_t(0));
            EXPECT_LE(before[i], time) << port << " " << i;
            EXPECT_GE(after[i], time) << port << " " << i;
        }
    }
}

TEST_F(LiveServer, AClientDoesNotLoadAPortWithWatches) {
    const auto source = makeSource("Source");
    RawClient one = client(), other = client();
    ASSERT_TRUE(one.open() && other.open());
    const auto watch = [](RawClient& by, int id) {
        return by.say({{"op", "oro.watch"}, {"id", id}, {"port", "Source.number"}, {"rate", 1}});
    };
    for (int id = 1; id != 5; ++id) {
        ASSERT_TRUE(watch(one, id));
        EXPECT_EQ(id, one.hear("oro.answer").value("id", 0));
    }
    ASSERT_TRUE(watch(one, 5));
    EXPECT_EQ("port 'Source.number' cannot be watched: you watch it 4 times already",
              one.hear("oro.error").value("message", ""));
    ASSERT_TRUE(watch(other, 1));
    EXPECT_EQ(1, other.hear("oro.answer").value("id", 0));
    ASSERT_TRUE(one.say({{"op", "oro.unwatch"}, {"id", 6}, {"watch", 1}}));
    EXPECT_EQ(6, one.hear("oro.answer").value("id", 0));
    ASSERT_TRUE(watch(one, 7));
    EXPECT_EQ(7, one.hear("oro.answer").value("id", 0));
}

TEST_F(LiveServer, LargeSamplesGetAShorterBuffer) {
    RTT::TaskContext quiet("Quiet");
    RTT::OutputPort<std::string> text("text");
    quiet.addPort(text);
    deployer.addPeer(&quiet);
    text.write(std::string(100000, 'x'));
    RawClient one = client();
    ASSERT_TRUE(one.open());
    ASSERT_TRUE(one.say({{"op", "oro.watch"}, {"id", 1}, {"port", "Quiet.text"}, {"buffer", 10000}}));
    EXPECT_EQ(1, one.hear("oro.answer").value("id", 0));
    EXPECT_EQ(100000U, one.hear("oro.sample").value("value", "").size());
    ASSERT_TRUE(one.say({{"op", "oro.show"}, {"id", 2}, {"path", "Quiet.text"}}));
    const json shown = one.hear("oro.answer")["result"]["connections"];
    EXPECT_NE(std::string::npos, shown.dump().find("83")) << shown;
    EXPECT_EQ(std::string::npos, shown.dump().find("10000")) << shown;
}

TEST_F(LiveServer, AWatchEndsWithItsComponent) {
    auto source = makeSource("Source");
    RawClient one = client();
    ASSERT_TRUE(one.open());
    ASSERT_TRUE(one.say({{"op", "oro.watch"}, {"id", 1}, {"port", "Source.number"}}));
    EXPECT_FALSE(one.hear("oro.sample").is_null());
    source.reset();
    EXPECT_EQ("LIV008", one.hear("oro.error").value("code", ""));
    ASSERT_TRUE(one.say({{"op", "oro.watch"}, {"id", 1}, {"port", "Source.number"}}));
    EXPECT_EQ("LIV003", one.hear("oro.error").value("code", ""));
}

TEST_F(LiveServer, LinesOfTheLogArriveBesideAnotherReceiver) {
    RawClient one = client();
    ASSERT_TRUE(one.open());
    ASSERT_TRUE(one.say({{"op", "oro.log"}, {"id", 5}, {"level", "error"}}));
    ASSERT_EQ(5, one.hear("oro.answer").value("id", 0));
    const RTT::Logger::In in("Test");
    RTT::log(RTT::Info) << "not this" << RTT::endlog();
    RTT::log(RTT::Error) << "but \xff this" << RTT::endlog();
    const json line = one.hear("oro.line");
    EXPECT_EQ("Error", line.value("level", ""));
    EXPECT_EQ("Test", line.value("origin", ""));
    EXPECT_EQ("but \uFFFD this", line.value("text", ""));
}

TEST_F(LiveServer, FoxgloveGetsChannelsOfComponentsThatComeAndGo) {
    auto source = makeSource("Source");
    RawClient fox = client();
    ASSERT_TRUE(fox.open("foxglove.sdk.v1"));
    ASSERT_TRUE(fox.say({{"op", "getParameters"}, {"parameterNames", json::array()}, {"id", "early"}}));
    EXPECT_EQ("serverInfo", fox.hear().value("op", ""));
    // Foxglove takes the time that it has at the first channel for the start of the data.
    const json time = fox.hear();
    ASSERT_TRUE(time.is_string());
    EXPECT_EQ('\x02', time.get<std::string>()[0]);
    EXPECT_EQ("/rosout", fox.hear("advertise").value("/channels/0/topic"_json_pointer, ""));
    const json channels = fox.hear("advertise")["channels"];
    ASSERT_EQ(2U, channels.size());
    EXPECT_EQ("/Source/number", channels[0].value("topic", ""));
    EXPECT_EQ("cdr", channels[0].value("encoding", ""));
    EXPECT_EQ("ros2msg", channels[0].value("schemaEncoding", ""));
    ASSERT_TRUE(fox.say({{"op", "subscribe"}, {"subscriptions", {{{"id", 9}, {"channelId", channels[0]["id"]}}}}}));
    const auto timeAt = [](const std::string& bytes, std::size_t at) {
        std::int64_t time = 0;
        std::memcpy(&time, bytes.data() + at, sizeof time);
        return time;
    };
    std::int64_t shown = 0;  // Foxglove shows a sample at the latest time message
    json parameters;         // these were asked for before the components were known
    for (int samples = 0; samples < 20 || parameters.is_null();) {
        const json message = fox.hear();
        ASSERT_FALSE(message.is_null());
        if (!message.is_string()) {
            if (message.value("op", "") == "parameterValues") parameters = message;
            continue;
        }
        const auto bytes = message.get<std::string>();
        if (bytes[0] == 2) {
            EXPECT_GT(timeAt(bytes, 1), shown);
            shown = timeAt(bytes, 1);
        }
        if (bytes[0] != 1) continue;
        EXPECT_EQ(std::string("\x01\x09\0\0\0", 5), bytes.substr(0, 5));
        EXPECT_EQ(1U + 4 + 8 + 4 + 8, bytes.size());
        EXPECT_LT(timeAt(bytes, 5) - shown, 1000000);
        EXPECT_GT(timeAt(bytes, 5) - shown, -1000000000);
        ++samples;
    }
    EXPECT_EQ("Source.gain", parameters.value("/parameters/0/name"_json_pointer, "")) << parameters;
    // The graph has the topics that are not read, and not the live window, which reads one.
    ASSERT_TRUE(fox.say({{"op", "subscribeConnectionGraph"}}));
    json graph = fox.hear("connectionGraphUpdate");
    const auto idsOf = [](const json& all, const std::string& topic, const char* ids) {
        for (const json& one : all)
            if (one.value("name", "") == topic) return one[ids];
        return json();
    };
    EXPECT_EQ(json({"Source"}), idsOf(graph["publishedTopics"], "/Source/number", "publisherIds"));
    EXPECT_EQ(json::array(), idsOf(graph["subscribedTopics"], "/Source/number", "subscriberIds"));
    source.reset();
    EXPECT_EQ(2U, fox.hear("unadvertise")["channelIds"].size());
    graph = fox.hear("connectionGraphUpdate");
    EXPECT_EQ(json({"/Source/number", "/Source/texts"}), graph["removedTopics"]);
    EXPECT_TRUE(graph["publishedTopics"].empty());
}

/** Does at random what a client may do. */
void beClient(RawClient client, std::mt19937& random) {
    if (!client.connected() || random() % 8 == 0) return;
    const bool fox = random() % 3 == 0;
    if (!client.open(fox ? "foxglove.sdk.v1" : "oro.v1")) return;
    for (int i = 0; i < 12; ++i) {
        const std::string port = "Source" + std::to_string(random() % 3) + (random() % 2 ? ".number" : ".texts");
        switch (random() % 6) {
            case 0:
            case 1: (void)client.say({{"op", "oro.watch"}, {"id", random() % 5}, {"port", port}}); break;
            case 2: (void)client.say({{"op", "oro.unwatch"}, {"id", 100}, {"watch", random() % 5}}); break;
            case 3: (void)client.say({{"op", "oro.log"}, {"id", random() % 5}}); break;
            case 4: (void)client.say({{"op", "oro.tree"}, {"id", 101}}); break;
            case 5:
                (void)client.say({{"op", "subscribe"}, {"subscriptions", {{{"id", i}, {"channelId", random() % 12}}}}});
                break;
        }
        for (unsigned heard = random() % 20; heard > 0; --heard)
            if (client.hear().is_null()) return;
        if (random() % 4 == 0) return;
    }
}

TEST_F(LiveServer, ClientsWatchWhileComponentsComeAndGoAndTheServerRestarts) {
    std::atomic<bool> ended{false};
    std::vector<std::thread> threads;
    for (unsigned int i = 0; i < 3; ++i)
        threads.emplace_back([&, i] {
            std::mt19937 random(i);
            while (!ended) beClient(client(), random);
        });
    threads.emplace_back([&] {
        std::mt19937 random(7);
        std::unique_ptr<Source> sources[3];
        while (!ended) {
            const std::size_t which = random() % 3;
            sources[which].reset();
            if (random() % 4 != 0) sources[which] = makeSource("Source" + std::to_string(which));
            RTT::log(RTT::Warning) << "one more" << RTT::endlog();
            std::this_thread::sleep_for(std::chrono::milliseconds(random() % 20));
        }
    });
    for (int i = 0; i < 4; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(600));
        server.reset();
        start();
    }
    ended = true;
    server.reset();
    start();  // so that clients that wait for an answer get one
    for (std::thread& thread : threads) thread.join();
}

}  // namespace
