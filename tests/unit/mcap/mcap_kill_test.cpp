// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A recorder that is killed leaves a file in which only the last ChunkTime is missing. MCAP_KILLS=200 kills more often.
#include "mcap_files.hpp"

#include <support/child_process.hpp>
#include <support/golden.hpp>
#include <support/temp_dir.hpp>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <map>
#include <random>
#include <thread>

namespace {

using namespace mcap_test;
using namespace oroforge::test;
using std::chrono::milliseconds;

/** ChunkTime of the recorder, and what a busy machine adds to it. */
constexpr double kMissing = 0.05 + 1.0;

TEST(KilledRecorder, LeavesAllButTheLastChunkTime) {
    const char* const wanted = std::getenv("MCAP_KILLS");
    const int kills = wanted ? std::atoi(wanted) : 6;
    std::mt19937 random(static_cast<unsigned>(kills));
    const TempDir directory;
    const std::vector<Compression> all = compressions();
    for (int i = 0; i != kills; ++i) {
        const Compression compression = all[static_cast<std::size_t>(i) % all.size()];
        Command command;
        command.program = RECORDER_PROGRAM;
        command.arguments = {(directory / "run.mcap").string(),
                             compression == Compression::None ? "none" : nameOf(compression)};
        command.environment["ORO_LOGFILE"] = "/dev/null";
        ChildProcess child(command);
        ASSERT_TRUE(child.waitForOutput("ready", milliseconds(30000))) << child.finish().err;
        std::this_thread::sleep_for(milliseconds(100 + random() % 300));
        child.send(SIGKILL);
        const double end = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
        (void)child.finish();
        const std::string bytes = readFile(directory / "run.mcap");
        const Found found(Bytes(bytes.begin(), bytes.end()));
        ASSERT_THAT(codesOf(found.problems), testing::ElementsAre("MCP002")) << i;
        ASSERT_FALSE(found.messages.empty()) << i;
        EXPECT_LT(end - static_cast<double>(std::get<2>(found.messages.back())) / 1e9, kMissing) << i;
        std::map<std::uint16_t, std::uint32_t> next;
        for (const auto& [channel, sequence, time, data] : found.messages) ASSERT_EQ(next[channel]++, sequence) << i;
        MemorySource source(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
        MemorySink sink;
        const Salvaged salvaged = salvage(source, sink);
        EXPECT_EQ(found.messages.size(), salvaged.messages);
        EXPECT_EQ(found.messages, Found(sink.bytes).messages);
    }
}

}  // namespace
