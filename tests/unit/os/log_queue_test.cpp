// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The queue for lines of real-time threads, by itself.
#include <rtt/detail/log_queue.hpp>

#include <atomic>
#include <gtest/gtest.h>
#include <string>
#include <thread>
#include <vector>

using RTT::detail::LogQueue;
using RTT::detail::LogRecord;

namespace {

bool put(LogQueue& queue, const std::string& module, const std::string& text, std::int64_t time = 0) {
    LogRecord record{};
    record.time = time;
    record.moduleSize = static_cast<std::uint16_t>(module.size());
    record.textSize = static_cast<std::uint16_t>(text.size());
    return queue.put(record, module.data(), text.data());
}

/** "module|text", or nothing. */
std::string take(LogQueue& queue, LogRecord& record) {
    char bytes[LogQueue::kLongest];
    if (!queue.take(record, bytes)) return {};
    return std::string(bytes, record.moduleSize) + "|" + std::string(bytes + record.moduleSize, record.textSize);
}
std::string take(LogQueue& queue) {
    LogRecord record;
    return take(queue, record);
}

/** A text that depends on its number, of lengths around those of one, two, … cells. */
std::string textOf(int number) {
    const std::size_t size = number % 7 == 0 ? LogQueue::kLongest - 10 : static_cast<std::size_t>(number * 37 % 500);
    std::string text = std::to_string(number) + " ";
    while (text.size() < size) text += static_cast<char>('a' + (number + static_cast<int>(text.size())) % 26);
    return text;
}

}  // namespace

TEST(LogQueue, LinesComeOutAsTheyWentIn) {
    LogQueue queue;
    EXPECT_EQ(take(queue), "");
    EXPECT_TRUE(put(queue, "", ""));
    EXPECT_EQ(take(queue), "|");
    for (std::uint32_t size : {1u, LogQueue::kRoom - 1, LogQueue::kRoom, LogQueue::kRoom + 1, LogQueue::kLongest - 5}) {
        const std::string text(size, 'x');
        ASSERT_TRUE(put(queue, "12345", text, size));
        LogRecord record;
        EXPECT_EQ(take(queue, record), "12345|" + text);
        EXPECT_EQ(record.time, size);
    }
    const std::string longModule(255, 'm');
    put(queue, longModule, "t");
    EXPECT_EQ(take(queue), longModule + "|t") << "a module may take more than a cell";
}

TEST(LogQueue, AFullQueueRefusesAndCounts) {
    LogQueue queue;
    for (std::uint32_t i = 0; i != LogQueue::kCells; ++i) ASSERT_TRUE(put(queue, "m", std::to_string(i)));
    EXPECT_FALSE(put(queue, "m", "no room"));
    EXPECT_FALSE(put(queue, "m", "no room"));
    EXPECT_EQ(queue.takeLost(), 2u);
    EXPECT_EQ(queue.takeLost(), 0u);
    EXPECT_EQ(take(queue), "m|0");
    EXPECT_FALSE(put(queue, "m", std::string(LogQueue::kRoom, 'x'))) << "needs two cells";
    EXPECT_TRUE(put(queue, "m", "one cell"));
    for (std::uint32_t i = 1; i != LogQueue::kCells; ++i) ASSERT_EQ(take(queue), "m|" + std::to_string(i));
    EXPECT_EQ(take(queue), "m|one cell");
    EXPECT_EQ(take(queue), "");
}

TEST(LogQueue, GoesRoundWithLinesOfAllLengths) {
    LogQueue queue;
    int in = 0, out = 0;
    while (out < 20000) {
        while (put(queue, "m", textOf(in))) ++in;
        for (const int last = out + 1 + in % 50; out < last && out < in; ++out)
            ASSERT_EQ(take(queue), "m|" + textOf(out));
    }
}

// Also the case for ThreadSanitizer.
TEST(LogQueueStress, KeepsTheLinesOfEachThreadWholeAndInOrder) {
    LogQueue queue;
    constexpr int kThreads = 4, kLines = 20000;
    std::atomic<int> refused{0}, running{kThreads};
    std::vector<std::thread> threads;
    for (int t = 0; t < kThreads; ++t)
        threads.emplace_back([&, t] {
            for (int i = 0; i < kLines; ++i)
                if (!put(queue, std::to_string(t), textOf(i))) {
                    ++refused;
                    std::this_thread::yield();
                }
            --running;
        });
    std::vector<int> next(kThreads, 0);
    int taken = 0;
    std::uint32_t lost = 0;
    for (bool last = false;;) {
        const std::string line = take(queue);
        if (line.empty()) {
            if (last) break;
            last = running == 0;  // what was put before that is there now
            continue;
        }
        const int t = line[0] - '0', number = std::stoi(line.substr(2));
        ASSERT_GE(number, next[static_cast<std::size_t>(t)]) << "not in order";
        ASSERT_EQ(line.substr(2), textOf(number)) << "not whole";
        next[static_cast<std::size_t>(t)] = number + 1;
        ++taken;
        lost += queue.takeLost();
    }
    for (auto& thread : threads) thread.join();
    lost += queue.takeLost();
    EXPECT_EQ(taken + refused, kThreads * kLines);
    EXPECT_EQ(lost, static_cast<std::uint32_t>(refused));
}
