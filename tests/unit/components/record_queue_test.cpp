// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <reporting/record_queue.hpp>

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

namespace {

using OCL::reporting::RecordQueue;

bool push(RecordQueue& queue, const std::string& record) { return queue.push(record.data(), record.size()); }

std::string pop(RecordQueue& queue) {
    std::vector<char> record;
    return queue.pop(record) ? std::string(record.begin(), record.end()) : "(none)";
}

TEST(RecordQueue, KeepsTheOrderAcrossItsRings) {
    RecordQueue queue(1);
    EXPECT_TRUE(queue.empty());
    EXPECT_TRUE(push(queue, "one"));
    EXPECT_FALSE(push(queue, std::string(queue.capacity(), 'x')));
    queue.makeRoom(2 * queue.capacity());
    EXPECT_TRUE(push(queue, "two"));
    queue.makeRoom(2 * queue.capacity());
    queue.makeRoom(2 * queue.capacity());  // nothing came into the one before
    EXPECT_TRUE(push(queue, "three"));
    for (const char* expected : {"one", "two", "three", "(none)"}) EXPECT_EQ(expected, pop(queue));
    EXPECT_TRUE(queue.empty());
    EXPECT_TRUE(push(queue, "four"));
    EXPECT_FALSE(queue.empty());
}

TEST(RecordQueue, DropsRecordsAndTellsHowTheyBegin) {
    RecordQueue queue(1);
    EXPECT_TRUE(push(queue, "one"));
    EXPECT_TRUE(push(queue, std::string(3000, 'x')));
    queue.makeRoom(2 * queue.capacity());
    EXPECT_TRUE(push(queue, "three"));
    char begin[5] = "....";
    EXPECT_TRUE(queue.drop(begin, 4));
    EXPECT_EQ("one.", std::string(begin));
    EXPECT_TRUE(queue.drop(begin, 4));
    EXPECT_EQ("xxxx", std::string(begin));
    EXPECT_EQ("three", pop(queue));
    EXPECT_FALSE(queue.drop(begin, 4));
}

TEST(RecordQueue, NothingIsLostWhileItGrowsBetweenTwoThreads) {
    constexpr int kRecords = 20000;
    RecordQueue queue(1);
    std::thread filler([&queue] {
        for (int i = 0; i < kRecords; ++i) {
            if (i % 4000 == 0) queue.makeRoom(2 * queue.capacity());
            while (!push(queue, std::to_string(i))) std::this_thread::yield();
        }
    });
    for (int i = 0; i < kRecords; ++i) {
        while (queue.empty()) std::this_thread::yield();
        const std::string record = pop(queue);
        if (record == "(none)")
            --i;  // only the next ring was there
        else
            EXPECT_EQ(std::to_string(i), record);
    }
    filler.join();
}

}  // namespace
