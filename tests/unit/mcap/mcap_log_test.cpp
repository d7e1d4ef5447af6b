// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The log, and what a recording says of its origin.
#include "mcap_report_fixture.hpp"

#include <reporting/schema/message_schema.hpp>
#include <rtt/LogReceiver.hpp>
#include <rtt/deployment/deployed_texts.hpp>
#include <rtt/types/StructTable.hpp>

#include <cstddef>
#include <map>
#include <utility>

namespace {

using namespace mcap_test;
using testing::SizeIs;

struct LogParts : oroforge::schema::PartTaker {
    void beginStruct() override {}
    void field(std::string_view name) override { at = name; }
    void endStruct() override {}
    void beginList() override {}
    void element(std::size_t) override {}
    void endList() override {}
    void number(std::string_view number) override {
        if (at == "sec") seconds = std::stoull(std::string(number));
        if (at == "nanosec") nanoseconds = std::stoull(std::string(number));
        if (at == "level") level = number;
    }
    void text(std::string_view value) override {
        if (at == "name") name = value;
        if (at == "msg") message = value;
    }
    std::string at, name, message, level;
    std::uint64_t seconds = 0, nanoseconds = 0;
};

TEST_F(Recorder, HasTheLog) {
    set("Log", true);
    ASSERT_TRUE(recorder->reportPort("Machine", "speed") && recorder->start());
    {
        const RTT::Logger::In in("pump");
        RTT::log(RTT::Warning) << "it leaks" << RTT::endlog();
        RTT::log(RTT::Error) << std::string(100000, 'x') << RTT::endlog();
    }
    recorder->stop();
    RTT::log(RTT::Error) << "too late" << RTT::endlog();
    const Found found = read();
    EXPECT_EQ("/rosout", found.channels.at(1).topic);
    const Schema& schema = found.schemas.at(found.channels[1].schema - 1U);
    EXPECT_EQ("rcl_interfaces/msg/Log", schema.name);
    std::vector<std::string> lines;
    std::string why;
    oroforge::schema::MessageSchema parsed;
    ASSERT_TRUE(parsed.read(schema.encoding, schema.name, schema.data, why)) << why;
    for (const auto& [channel, sequence, time, data] : found.messages) {
        ASSERT_EQ(2, channel);
        LogParts parts;
        EXPECT_TRUE(parsed.walk(reinterpret_cast<const unsigned char*>(data.data()), data.size(), parts, why)) << why;
        EXPECT_EQ(time, parts.seconds * 1000000000 + parts.nanoseconds);
        EXPECT_LE(time, static_cast<std::uint64_t>(RTT::os::TimeService::Instance()->getNSecs()));
        if (parts.name == "pump") lines.push_back(parts.level + " " + parts.message);
    }
    ASSERT_THAT(lines, SizeIs(2));
    EXPECT_EQ("30 it leaks", lines[0]);
    EXPECT_EQ("40 " + std::string(65536, 'x') + " … (34464 more characters)", lines[1]);
}

TEST_F(Recorder, CountsLinesOfTheLogThatAreLost) {
    struct Nobody : RTT::LogReceiver {
        void receive(const RTT::LogEntry&) override {}
    };
    set("Log", true);
    ASSERT_TRUE(recorder->reportPort("Machine", "speed") && recorder->start());
    const RTT::Logger::In in("pump");
    for (int i = 0; i != 1500; ++i) {
        RTT::log(RTT::Info) << "line " << i << RTT::endlog();
        if (i % 300 != 299) continue;
        Nobody nobody;
        RTT::addLogObserver(nobody);
        RTT::removeLogObserver(nobody);  // waits for those before
    }
    step();
    RTT::log(RTT::Info) << "the last line" << RTT::endlog();
    recorder->stop();
    const Found found = read();
    std::uint32_t last = 0;
    for (const auto& [channel, sequence, time, data] : found.messages) last = sequence;
    const std::uint64_t lost = std::stoull(found.allMetadata.back().texts.at("/rosout"));
    EXPECT_GE(lost, 500U);
    EXPECT_EQ(last + 1, found.messages.size() + lost);
}

struct Stamped {
    double value = 0;
    long long made = 0;
};
struct WronglyStamped {
    double made = 0;
};
constexpr RTT::types::Member kStamped[] = {
    {"value", offsetof(Stamped, value), &RTT::types::typeRef<double>, 0, "", ""},
    {"made", offsetof(Stamped, made), &RTT::types::typeRef<long long>, 0, "When. @stamp", ""}};
constexpr RTT::types::Member kWronglyStamped[] = {
    {"made", offsetof(WronglyStamped, made), &RTT::types::typeRef<double>, 0, "@stamp", ""}};

struct PublishTimes : Visitor {
    void channel(const Channel& one) override { topics[one.id] = one.topic; }
    void message(const Message& one) override { times[topics[one.channel]] = {one.logTime, one.publishTime}; }
    std::map<std::uint16_t, std::string> topics;
    std::map<std::string, std::pair<std::uint64_t, std::uint64_t>> times;
};

TEST_F(Recorder, HasTheStampsOfValues) {
    RTT::types::Types()->addType(RTT::types::makeStructType<Stamped>("/test/Stamped", kStamped, 2));
    RTT::types::Types()->addType(RTT::types::makeStructType<WronglyStamped>("/test/Wrong", kWronglyStamped, 1));
    const LogText log;
    RTT::TaskContext camera("Camera");
    RTT::OutputPort<Stamped> image("image"), later("later");
    RTT::OutputPort<WronglyStamped> wrong("wrong");
    camera.addPort(image);
    camera.addPort(later);
    camera.addPort(wrong);
    recorder->addPeer(&camera);
    ASSERT_TRUE(recorder->reportComponent("Camera") && recorder->start());
    image.write({1, 12345});
    later.write({1, -5});  // no time
    wrong.write({7});
    recorder->stop();
    recorder->removePeer("Camera");
    const std::string bytes = oroforge::test::readFile(directory / "run.mcap");
    MemorySource source(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
    PublishTimes found;
    (void)scan(source, found);
    EXPECT_EQ(12345U, found.times.at("/Camera/image").second);
    EXPECT_NE(12345U, found.times.at("/Camera/image").first);
    for (const char* const topic : {"/Camera/later", "/Camera/wrong"})
        EXPECT_EQ(found.times.at(topic).first, found.times.at(topic).second) << topic;
    EXPECT_THAT(log(), HasSubstr("messages of 'Camera.wrong' have the time of the recorder: error: [MCP013] its field "
                                 "'made' is marked @stamp"));
}

TEST_F(Recorder, HasTheTextsOfTheDeployment) {
    RTT::plugin::noteDeployedText("/one/app.xml", "<a/>\n");
    RTT::plugin::noteDeployedText("/two/app.xml", "<b/>\n");
    RTT::plugin::noteDeployedText("/one/app.xml", "<c/>\n");
    RTT::plugin::noteDeployedText("/large.xml", std::string(2000000, ' '));
    ASSERT_TRUE(recorder->reportPort("Machine", "speed") && recorder->start());
    recorder->stop();
    Found found = read();
    ASSERT_THAT(found.allMetadata, SizeIs(3));
    EXPECT_EQ(1U, found.allMetadata[0].texts.count("typekits"));
    EXPECT_EQ("oroforge.deployment", found.allMetadata[1].name);
    EXPECT_EQ("<c/>\n", found.allMetadata[1].texts.at("/one/app.xml"));
    EXPECT_EQ("<b/>\n", found.allMetadata[1].texts.at("/two/app.xml"));
    EXPECT_EQ("(2000000 bytes, which are too many)", found.allMetadata[1].texts.at("/large.xml"));
    set("Reproducible", true);
    ASSERT_TRUE(recorder->start());
    recorder->stop();
    found = read();
    EXPECT_EQ("<c/>\n", found.allMetadata.at(1).texts.at("app.xml"));
    EXPECT_EQ("<b/>\n", found.allMetadata.at(1).texts.at("app.xml'"));
}

}  // namespace
