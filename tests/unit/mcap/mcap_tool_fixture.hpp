// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The program oro-mcap, and a recording for it.
#ifndef OROFORGE_TESTS_MCAP_TOOL_FIXTURE_HPP
#define OROFORGE_TESTS_MCAP_TOOL_FIXTURE_HPP

#include "cdr_bytes.hpp"
#include "mcap_files.hpp"

#include <support/child_process.hpp>
#include <support/golden.hpp>
#include <support/temp_dir.hpp>

namespace mcap_test {

using oroforge::test::Command;
using oroforge::test::Outcome;
constexpr const char* kLevel =
    "float64 height  # The water. [m]\n"
    "string name\n"
    "int8 LEFT=-1\n"
    "int8 side\n"
    "tank/Point[] path\n"
    "bool[2] valves\n"
    "================================================================================\n"
    "MSG: tank/Point\n"
    "uint16 x\n"
    "float32 y\n";

inline std::string level(double height, const std::string& name, std::uint32_t points) {
    Cdr cdr;
    cdr.put(height).put(name).put(std::int8_t(-1)).put(points);
    for (std::uint32_t i = 0; i != points; ++i) cdr.put(static_cast<std::uint16_t>(i)).put(0.5F);
    cdr.put(true).put(false);
    return {cdr.bytes.begin(), cdr.bytes.end()};
}

class Tool : public testing::Test {
protected:
    Outcome run(const std::vector<std::string>& arguments) const {
        Command command;
        command.program = TOOL_PROGRAM;
        command.arguments = arguments;
        command.directory = directory.path();
        return oroforge::test::run(command);
    }
    Outcome expect(int status, const std::vector<std::string>& arguments) const {
        Outcome outcome = run(arguments);
        EXPECT_EQ(status, outcome.status) << outcome.out << outcome.err;
        return outcome;
    }
    /** Messages of /tank/level (1), and of /tank/count (2), one of which is missing. */
    void record(const std::string& name, const std::vector<Told>& messages, const std::string& schema = kLevel,
                const std::string& encoding = "ros2msg", const std::string& type = "tank/msg/Level") {
        MemorySink sink;
        Writer writer(sink);
        EXPECT_TRUE(writer.begin({"ros2", "a test"}));
        EXPECT_TRUE(writer.add(Schema{1, type, encoding, schema}));
        EXPECT_TRUE(writer.add(Schema{2, "std_msgs/msg/Int32", "ros2msg", "int32 data\n"}));
        EXPECT_TRUE(writer.add(Channel{1, 1, "/tank/level", "cdr", {}}));
        EXPECT_TRUE(writer.add(Channel{2, 2, "/tank/count", "cdr", {}}));
        PackedChunk packed;
        Chunk chunk(10000);
        std::string why;
        for (const Told& message : messages) {
            EXPECT_TRUE(addTo(chunk, message) && packed.pack(chunk, nullptr, why) && writer.write(packed));
            chunk.clear();
        }
        EXPECT_TRUE(writer.add(Metadata{"oroforge.lost", {{"all", "0"}}}) && writer.finish());
        directory.write(name, std::string(sink.bytes.begin(), sink.bytes.end()));
    }
    static std::vector<Told> messages() {
        const auto count = [](std::int32_t number) {
            Cdr cdr;
            cdr.put(number);
            return std::string(cdr.bytes.begin(), cdr.bytes.end());
        };
        return {{1, 0, 1500000000, level(1.5, "a \"quoted\", text\n", 1)},
                {2, 0, 2000000000, count(-7)},
                {1, 1, 2500000000, level(2.25, "b", 2)},
                {2, 2, 3000000000, count(9)}};
    }
    std::string readText(const std::string& name) const { return oroforge::test::readFile(directory / name); }

    oroforge::test::TempDir directory;
};

}  // namespace mcap_test

#endif
