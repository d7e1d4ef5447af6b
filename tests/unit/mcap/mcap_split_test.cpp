// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Recordings of several files, and rings.
#include "mcap_report_fixture.hpp"

#include <numeric>
#include <thread>

namespace {

using namespace mcap_test;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

TEST_F(Recorder, SplitsBySizeAndLosesNothing) {
    set("ChunkSize", 4096U);
    set<std::string>("Split", "20 kB");
    ASSERT_TRUE(recorder->reportPort("Machine", "speed") && recorder->start());
    for (int i = 0; i != 2000; ++i) {
        machine.speed.write(i);
        if (i % 100 == 99) {
            step();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    recorder->stop();
    std::vector<double> all;
    int files = 0;
    for (std::string name = "run.mcap"; std::filesystem::exists(directory / name); ++files) {
        const Found found = read(name);
        EXPECT_TRUE(found.scanned.hasEnd && found.problems.empty()) << name;
        const std::vector<double> part = numbersOf(found, "/Machine/speed");
        EXPECT_THAT(part, Not(IsEmpty()));
        all.insert(all.end(), part.begin(), part.end());
        EXPECT_LT(std::filesystem::file_size(directory / name), 23000U);
        name = "run_" + std::to_string(files + 1) + ".mcap";
    }
    EXPECT_GE(files, 4);
    std::vector<double> expected(2000);
    std::iota(expected.begin(), expected.end(), 0);
    EXPECT_EQ(expected, all);
}

TEST_F(Recorder, SplitsByTime) {
    set("ChunkSize", 4096U);
    set<std::string>("Split", "10 s");
    ASSERT_TRUE(recorder->reportPort("Machine", "levels") && recorder->start());
    for (int i = 0; i != 30; ++i) {
        machine.levels.write(std::vector<double>(300, i));
        step(1);
    }
    recorder->stop();
    std::size_t count = 0;
    for (const char* const name : {"run.mcap", "run_1.mcap", "run_2.mcap"}) count += read(name).messages.size();
    EXPECT_EQ(30U, count);
    EXPECT_GE(read("run_1.mcap").messages.size(), 9U);
}

TEST_F(Recorder, RingHasTheLastSeconds) {
    set("ChunkSize", 4096U);
    set("Ring", 5.0);
    for (const char* const compression : {"none", "zstd"}) {
        set<std::string>("Compression", compression);
        ASSERT_TRUE(recorder->reportPort("Machine", "levels") && recorder->start());
        for (int i = 0; i != 30; ++i) {
            machine.levels.write(std::vector<double>(300, i));
            step(1);
        }
        EXPECT_FALSE(std::filesystem::exists(directory / "run.mcap"));
        EXPECT_TRUE(recorder->save());
        machine.levels.write({0.5});
        step(1);
        EXPECT_TRUE(recorder->save());
        recorder->stop();
        const Found found = read();
        EXPECT_TRUE(found.scanned.hasEnd && found.problems.empty());
        EXPECT_GE(found.messages.size(), 5U);
        EXPECT_LE(found.messages.size(), 8U);
        EXPECT_THAT(std::get<3>(read("run_1.mcap").messages.back()), SizeIs(20));
        for (const char* const name : {"run.mcap", "run_1.mcap"}) std::filesystem::remove(directory / name);
    }
    const LogText log;
    EXPECT_FALSE(recorder->save());
    EXPECT_THAT(log(), HasSubstr("'Recorder' saved nothing: it must run"));
}

TEST_F(Recorder, RingThatCannotBeSavedSaysWhyAndCanBeSavedAgain) {
    const LogText log;
    set("Ring", 5.0);
    set<std::string>("ReportFile", (directory / "later" / "run.mcap").string());
    ASSERT_TRUE(recorder->reportPort("Machine", "levels") && recorder->start());
    machine.levels.write({1});
    step(1);
    EXPECT_FALSE(recorder->save());
    EXPECT_THAT(log(), HasSubstr("run.mcap' for recording: No such file or directory"));
    EXPECT_THAT(log(), Not(HasSubstr("it must run")));
    std::filesystem::create_directory(directory / "later");
    EXPECT_TRUE(recorder->save());
    recorder->stop();
    EXPECT_THAT(read("later/run_1.mcap").messages, SizeIs(testing::Ge(1U)));
}

TEST_F(Recorder, RingTakesNoMoreMemoryThanItMay) {
    const LogText log;
    set("ChunkSize", 4096U);
    set("Ring", 1000.0);
    set<std::string>("RingSize", "20 kB");
    ASSERT_TRUE(recorder->reportPort("Machine", "levels") && recorder->start());
    for (int i = 0; i != 40; ++i) {
        machine.levels.write(std::vector<double>(300, i));
        step(1);
    }
    EXPECT_TRUE(recorder->save());
    recorder->stop();
    const Found found = read();
    EXPECT_TRUE(found.scanned.hasEnd && found.problems.empty());
    EXPECT_GE(found.messages.size(), 3U);
    EXPECT_LE(std::filesystem::file_size(directory / "run.mcap"), 22000U);
    double last = 0;
    std::memcpy(&last, std::get<3>(found.messages.back()).data() + 12, sizeof last);
    EXPECT_EQ(39, last);
    const std::string said = log();
    const std::size_t first = said.find("has less than 1000 seconds: they need more than the 20000 bytes");
    ASSERT_NE(said.npos, first) << said;
    EXPECT_EQ(said.npos, said.find("has less than", first + 20));
}

}  // namespace
