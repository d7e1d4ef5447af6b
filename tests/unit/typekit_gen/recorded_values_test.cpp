// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Values of every type of the golden typekits are recorded, and read by the libraries of MCAP and Foxglove
// (tests/judges), which know nothing of us: they find what our JSON says. `./dev judges` installs those libraries.
#include <ocl/McapReporting.hpp>
#include <replay/player.hpp>
#include <reporting/mcap/salvage.hpp>
#include <reporting/mcap/scan.hpp>
#include <reporting/schema/message_schema.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/encoding/Json.hpp>
#include <rtt/encoding/SchemaText.hpp>
#include <rtt/Property.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/os/TimeService.hpp>
#include <rtt/types/Types.hpp>
#include <support/child_process.hpp>
#include <support/golden.hpp>
#include <support/temp_dir.hpp>

#include "shape_filler.hpp"

#include <dlfcn.h>
#include <gmock/gmock.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <vector>

namespace {

using namespace oroforge::test;
using RTT::types::TypeInfo;
using testing::HasSubstr;

void load(const std::string& file) {
    void* const library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    ASSERT_NE(library, nullptr) << ::dlerror();
    ASSERT_TRUE(reinterpret_cast<bool (*)(RTT::TaskContext*)>(::dlsym(library, "loadRTTPlugin"))(nullptr));
}

class AllValues : public testing::Test {
protected:
    static void SetUpTestSuite() {
        load(RTT_TYPEKIT_FILE);
        std::istringstream words(GOLDEN_TYPEKITS);
        for (std::string word; words >> word;)
            load(std::string(GOLDEN_TYPEKIT_DIR) + "/libgolden_typekit_" + word + ".so");
    }
    template <class T>
    static void set(RTT::TaskContext& component, const char* name, const T& value) {
        dynamic_cast<RTT::Property<T>&>(*component.getProperty(name)).set(value);
    }

    /** Records two values of each type; returns the number of messages. */
    std::size_t record(const std::string& compression, const std::string& schema) {
        RTT::TaskContext types("Types");
        OCL::McapReporting recorder("Recorder");
        recorder.addPeer(&types);
        recorder.setActivity(new RTT::extras::SlaveActivity(0.01));
        set<std::string>(recorder, "ReportFile", (directory / "run.mcap").string());
        set<std::string>(recorder, "Compression", compression);
        set<std::string>(recorder, "Schema", schema);
        set(recorder, "ChunkSize", 4096U);
        set(recorder, "Log", false);
        std::vector<std::unique_ptr<RTT::base::OutputPortInterface>> ports;
        for (const std::string& name : RTT::types::Types()->getTypes()) {
            const TypeInfo& type = *RTT::types::Types()->type(name);
            RTT::encoding::SchemaText text;
            std::string why;
            if (*type.getArrayElement() != '\0' || !type.buildValue()) continue;
            const auto language =
                schema == "omgidl" ? RTT::encoding::SchemaLanguage::OmgIdl : RTT::encoding::SchemaLanguage::Auto;
            if (!RTT::encoding::describeType(type, language, false, text, why)) continue;
            std::unique_ptr<RTT::base::OutputPortInterface> port(type.outputPort("t" + std::to_string(ports.size())));
            if (!port) continue;  // no type of samples
            ports.push_back(std::move(port));
            types.addPort(*ports.back());
            EXPECT_TRUE(recorder.reportPort("Types", ports.back()->getName())) << name;
        }
        EXPECT_TRUE(recorder.start());
        std::ofstream expected(directory / "expected.txt");
        expected << R"({"topic": "/oroforge/states", "value": {"component": "Types", "state": "Stopped"}})"
                 << "\n";
        std::size_t messages = 1;
        for (unsigned seed = 0; seed != 2; ++seed)
            for (const auto& port : ports) {
                const TypeInfo& type = *port->getTypeInfo();
                const auto value = type.buildValue();
                fillShape(type, value->getRawPointer(), seed * 100 + 1);
                std::string why;
                expected << "{\"topic\": \"/Types/" << port->getName()
                         << "\", \"value\": " << RTT::encoding::Json::make(type, why)->text(value->getRawConstPointer())
                         << "}\n";
                EXPECT_EQ(RTT::WriteSuccess, port->write(value));
                ++messages;
            }
        recorder.update();
        recorder.stop();
        return messages;
    }
    TempDir directory;
};

class RecordedValues : public AllValues {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(std::string(JUDGES_DIR) + "/node_modules"))
            GTEST_SKIP() << "the libraries that judge are not installed: ./dev judges";
    }
    Outcome judge(std::vector<std::string> words) const {
        Command command;
        command.program = "node";
        words.insert(words.begin(), JUDGE);
        command.arguments = words;
        command.directory = JUDGES_DIR;
        return run(command);
    }
};

/** Takes the messages apart as oro-mcap does. */
struct Parts : oroforge::mcap::Visitor, oroforge::schema::PartTaker {
    void schema(const oroforge::mcap::Schema& one) override { described[one.id] = one; }
    void channel(const oroforge::mcap::Channel& one) override {
        const oroforge::mcap::Schema& its = described[one.schema];
        std::string why;
        EXPECT_TRUE(schemas[one.id].read(its.encoding, its.name, its.data, why)) << why << "\n" << its.data;
        encodings.insert(its.encoding);
    }
    void message(const oroforge::mcap::Message& one) override {
        std::string why;
        all += "\n";
        EXPECT_TRUE(schemas[one.channel].walk(one.data, one.size, *this, why)) << why << "\n"
                                                                               << described[one.channel].data;
        ++messages;
    }
    void problem(const oroforge::mcap::Problem& one) override { ADD_FAILURE() << one.line("run.mcap"); }
    void beginStruct() override { all += "{"; }
    void field(std::string_view name) override { all += std::string(name) + ": "; }
    void endStruct() override { all += "}"; }
    void beginList() override { all += "["; }
    void element(std::size_t) override { all += ","; }
    void endList() override { all += "]"; }
    void number(std::string_view text) override { all += text; }
    void text(std::string_view text) override { all += text; }

    std::map<std::uint16_t, oroforge::mcap::Schema> described;
    std::map<std::uint16_t, oroforge::schema::MessageSchema> schemas;
    std::set<std::string> encodings;
    std::string all;
    std::size_t messages = 0;
};

TEST_F(AllValues, AreReadByOurTool) {
    std::string texts[2];
    for (const bool isIdl : {false, true}) {
        const std::size_t messages = record("none", isIdl ? "omgidl" : "auto");
        const std::string bytes = readFile(directory / "run.mcap");
        oroforge::mcap::MemorySource source(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
        Parts parts;
        (void)oroforge::mcap::scan(source, parts);
        EXPECT_EQ(messages, parts.messages);
        EXPECT_EQ(1U, parts.encodings.count("omgidl"));
        texts[isIdl ? 1 : 0] = parts.all;
    }
    EXPECT_EQ(texts[0], texts[1]);
    EXPECT_GT(texts[0].size(), 1000U);
}

/** The values that a replay writes, as record() writes those that it expects. */
class Replayed {
public:
    Replayed(const std::string& file) : player_(oroOpenRecording(file.c_str(), {}, error_)) {
        EXPECT_TRUE(player_) << error_;
        if (!player_) return;
        for (const OCL::replay::Topic& topic : player_->topics()) {
            RTT::base::OutputPortInterface* const from = player_->port(topic.topic, error_);
            EXPECT_TRUE(from && error_.empty()) << error_;
            if (!from) continue;
            const TypeInfo& type = *from->getTypeInfo();
            readers_.push_back({topic.topic, std::unique_ptr<RTT::base::InputPortInterface>(type.inputPort("in")),
                                type.buildValue(), RTT::encoding::Json::make(type, error_)});
            EXPECT_TRUE(from->connectTo(readers_.back().port.get(), RTT::ConnPolicy::buffer(10)));
        }
        while (player_->next()) player_->deliver();
    }
    std::multiset<std::string> lines() {
        std::multiset<std::string> all;
        for (Reader& one : readers_)
            while (one.port->read(one.value) == RTT::NewData)
                all.insert("{\"topic\": \"" + one.topic +
                           "\", \"value\": " + one.json->text(one.value->getRawConstPointer()) + "}");
        return all;
    }
    std::vector<std::string> problems() const { return player_->problems(); }

private:
    struct Reader {
        std::string topic;
        std::unique_ptr<RTT::base::InputPortInterface> port;
        RTT::base::DataSourceBase::shared_ptr value;
        std::shared_ptr<const RTT::encoding::Json> json;
    };
    std::string error_;
    const std::unique_ptr<OCL::replay::Player> player_;
    std::vector<Reader> readers_;
};

TEST_F(AllValues, AreReplayed) {
    const std::string file = (directory / "run.mcap").string();
    for (const char* const schema : {"auto", "omgidl"}) {
        SCOPED_TRACE(schema);
        const std::size_t messages = record("none", schema);
        std::multiset<std::string> expected;
        std::istringstream lines(readFile(directory / "expected.txt"));
        for (std::string line; std::getline(lines, line);)
            if (line.find("/oroforge/states") == std::string::npos) expected.insert(line);
        EXPECT_EQ(messages, expected.size() + 1);
        Replayed known(file);
        EXPECT_EQ(expected, known.lines());
        EXPECT_THAT(known.problems(), testing::IsEmpty());
        // Without the fingerprints, the descriptions of the types are compared.
        const std::string bytes = replaceAll(readFile(file), "oroforge.fingerprint", "oroforge.unknown____");
        directory.write("run.mcap", bytes);
        Replayed compared(file);
        EXPECT_EQ(expected, compared.lines());
    }
}

TEST_F(RecordedValues, AreWhatOthersRead) {
    for (const char* const schema : {"auto", "omgidl"})
        for (const char* const compression : {"none", "lz4", "zstd"}) {
            SCOPED_TRACE(std::string(schema) + " " + compression);
            const std::size_t messages = record(compression, schema);
            EXPECT_GT(messages, 100U);
            const Outcome outcome =
                judge({"values", (directory / "run.mcap").string(), (directory / "expected.txt").string()});
            EXPECT_EQ(0, outcome.status) << outcome.out << outcome.err;
            EXPECT_THAT(outcome.out, HasSubstr("\"messages\": " + std::to_string(messages) + ","));
        }
}

TEST_F(RecordedValues, OfACutOrDamagedFileAreReadUpToThere) {
    const std::size_t messages = record("none", "auto");
    const std::string bytes = readFile(directory / "run.mcap");
    for (const double part : {0.3, 0.6, 0.9}) {
        directory.write("cut.mcap",
                        bytes.substr(0, static_cast<std::size_t>(part * static_cast<double>(bytes.size()))));
        const Outcome outcome = judge({"stream", (directory / "cut.mcap").string()});
        EXPECT_EQ(0, outcome.status) << outcome.out << outcome.err;
        EXPECT_THAT(outcome.out, HasSubstr("\"done\":false"));
    }
    const Outcome all = judge({"count", (directory / "run.mcap").string()});
    EXPECT_EQ(0, all.status) << all.out << all.err;
    EXPECT_THAT(all.out, HasSubstr("\"statistics\":\"" + std::to_string(messages) + "\""));
    EXPECT_THAT(all.out, HasSubstr("\"gaps\":0,\"ordered\":true"));
}

constexpr std::size_t kChunkHead = 60;  // more than what stands in front of the messages of a chunk

/** Where the chunks of a file begin. */
std::vector<std::size_t> chunksIn(const std::string& bytes) {
    std::vector<std::size_t> found;
    std::uint64_t length = 0;
    for (std::size_t at = 8; at + 9 <= bytes.size(); at += 9 + length) {
        if (bytes[at] == 6) found.push_back(at);
        std::memcpy(&length, bytes.data() + at + 1, sizeof length);
    }
    return found;
}

TEST_F(RecordedValues, OfASalvagedFileAreReadByItsIndex) {
    for (const char* const compression : {"none", "lz4", "zstd"}) {
        SCOPED_TRACE(compression);
        const std::size_t messages = record(compression, "auto");
        std::string bytes = readFile(directory / "run.mcap");
        const std::vector<std::size_t> chunks = chunksIn(bytes);
        ASSERT_GT(chunks.size(), 2U);
        char& damaged = bytes[chunks[chunks.size() / 2] + kChunkHead];
        damaged = static_cast<char>(damaged ^ 1);
        bytes.resize(chunks.back() + kChunkHead);
        oroforge::mcap::MemorySource source(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
        oroforge::mcap::MemorySink sink;
        const oroforge::mcap::Salvaged salvaged = oroforge::mcap::salvage(source, sink);
        EXPECT_GT(salvaged.messages, 10U);
        EXPECT_LT(salvaged.messages, messages);
        directory.write("salvaged.mcap", std::string(sink.bytes.begin(), sink.bytes.end()));
        const Outcome outcome = judge({"count", (directory / "salvaged.mcap").string()});
        EXPECT_EQ(0, outcome.status) << outcome.out << outcome.err;
        EXPECT_THAT(outcome.out, HasSubstr("\"statistics\":\"" + std::to_string(salvaged.messages) + "\""));
    }
}

}  // namespace
