// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <reporting/record.hpp>
#include <reporting/row_writer.hpp>

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>

namespace {

using namespace OCL::reporting;

constexpr std::size_t kRoom = 1 << 16;

Record row(std::int64_t number) {
    Record record;
    record.value(Tag::Signed, number);
    return record;
}

/** Keeps its writer waiting until it is opened; may fail then. */
class Gate : public TextTarget {
public:
    Gate(std::string& text, bool good) : text_(text), good_(good) {}

    std::string write(const char* text, std::size_t size) override {
        std::unique_lock<std::mutex> lock(mutex_);
        changed_.wait(lock, [this] { return open_; });
        if (!good_) return "the disk is full";
        text_.append(text, size);
        return {};
    }
    std::string name() const override { return "the gate"; }
    bool hasSeen(const std::string& text) {
        const std::lock_guard<std::mutex> lock(mutex_);
        return text_.find(text) != std::string::npos;
    }
    void open() {
        const std::lock_guard<std::mutex> lock(mutex_);
        open_ = true;
        changed_.notify_all();
    }

private:
    std::string& text_;
    const bool good_;
    bool open_ = false;
    std::mutex mutex_;
    std::condition_variable changed_;
};

TEST(RowWriter, WritesEverythingBeforeItEnds) {
    for (int round = 0; round < 50; ++round) {
        std::ostringstream text, expected;
        RowWriter writer("writer", useStream(text), kRoom, 6);
        for (int i = 0; i < round * 7; ++i) {
            ASSERT_TRUE(writer.push(row(i)));
            expected << ' ' << i << " \n";
        }
        writer.finish();
        ASSERT_EQ(expected.str(), text.str());
        ASSERT_EQ(0u, writer.lost());
    }
}

TEST(RowWriter, RowsComeOutByThemselves) {
    std::string text;
    auto* const gate = new Gate(text, true);
    RowWriter writer("writer", std::unique_ptr<TextTarget>(gate), kRoom, 6);
    gate->open();
    for (int i = 0; i < 20; ++i) {
        ASSERT_TRUE(writer.push(row(i)));
        // Sometimes it is asleep again, sometimes it gathers.
        std::this_thread::sleep_for(std::chrono::milliseconds(i));
    }
    for (int i = 0; i < 1000 && !gate->hasSeen(" 19 \n"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_TRUE(gate->hasSeen(" 19 \n"));
    writer.finish();
}

TEST(RowWriter, RowsThatFindNoRoomAreCounted) {
    std::string text;
    auto* const gate = new Gate(text, true);
    RowWriter writer("writer", std::unique_ptr<TextTarget>(gate), kRoom, 6);
    const Record record = row(1);
    unsigned long refused = 0, taken = 0;
    while (refused < 100) ++(writer.push(record) ? taken : refused);
    EXPECT_EQ(100u, writer.lost());
    gate->open();
    writer.finish();
    EXPECT_EQ(100u, writer.lost());
    EXPECT_EQ(taken * 4, text.size());  // " 1 \n"
}

TEST(RowWriter, NothingFollowsALineThatCouldNotBeWritten) {
    std::string text;
    auto* const gate = new Gate(text, false);
    RowWriter writer("writer", std::unique_ptr<TextTarget>(gate), kRoom, 6);
    gate->open();
    for (int i = 0; i < 10; ++i) ASSERT_TRUE(writer.push(row(i)));
    writer.finish();
    EXPECT_EQ(10u, writer.lost());
    EXPECT_EQ("", text);
}

TEST(RowWriter, FileThatCannotBeOpenedSaysWhy) {
    std::string error;
    EXPECT_EQ(nullptr, openFile("/no/such/folder/reports.dat", error));
    EXPECT_EQ("No such file or directory", error);
}

}  // namespace
