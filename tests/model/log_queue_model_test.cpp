// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>

#include <rtt/detail/log_queue.cpp>

namespace {

using model::require;
using model::Trial;
using RTT::detail::LogQueue;
using RTT::detail::LogRecord;

/** Lines with numbers; those with even ones need two cells. How often each was put and taken. */
struct Log {
    LogQueue queue;
    std::array<int, 7> in{}, out{};

    void put(int number) {
        LogRecord record{};
        record.time = number;
        const std::string text(number % 2 == 0 ? 4u : 1u, static_cast<char>('0' + number));
        record.textSize = static_cast<std::uint16_t>(text.size());
        in[static_cast<std::size_t>(number)] += queue.put(record, "", text.data());
    }
    /** The number, or 0. */
    int take() {
        LogRecord record{};
        char bytes[LogQueue::kLongest];
        if (!queue.take(record, bytes)) return 0;
        const int number = static_cast<int>(static_cast<std::int64_t>(record.time));
        require(record.textSize == (number % 2 == 0 ? 4 : 1), "not the length that was put");
        for (int i = 0; i != record.textSize; ++i) require(bytes[i] == '0' + number, "not the text that was put");
        ++out[static_cast<std::size_t>(number)];
        return number;
    }
    void settle() {
        for (int i = 0; i < 5; ++i) take();
        require(in == out, "a line is lost or came twice");
    }
};

void twoProducers(Trial& trial) {
    Log log;
    trial.thread([&] { log.put(1); });
    trial.thread([&] { log.put(2); });
    trial.thread([&] {
        log.take();
        log.take();
    });
    trial.go();
    require(log.in[1] == 1 && log.in[2] == 1, "refused though there was room");
    log.settle();
}

void goingRound(Trial& trial) {
    Log log;
    log.put(1);
    log.put(3);
    trial.thread([&] {
        log.put(4);
        log.put(5);
        log.put(6);
    });
    trial.thread([&] {
        int last = 0;
        for (int i = 0; i < 4; ++i) {
            const int number = log.take();
            require(number == 0 || number > last, "not first in, first out");
            last = number != 0 ? number : last;
        }
    });
    trial.go();
    log.settle();
}

/** There is room for one of them. */
void aLastPlace(Trial& trial) {
    Log log;
    log.put(2);
    trial.thread([&] { log.put(4); });
    trial.thread([&] { log.put(6); });
    trial.go();
    require(log.in[4] + log.in[6] == 1, "both, or none");
    require(log.queue.takeLost() == 1, "not counted");
    log.settle();
}

TEST(LogQueue, two_producers_and_one_consumer) { EXPECT_TRUE(model::holds(twoProducers)); }
TEST(LogQueue, one_producer_and_one_consumer_go_round) { EXPECT_TRUE(model::holds(goingRound)); }
TEST(LogQueue, two_producers_and_a_last_place) { EXPECT_TRUE(model::holds(aLastPlace)); }

TEST(LogQueue, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("log_queue_relaxed_put", twoProducers));
    EXPECT_TRUE(model::catches("log_queue_relaxed_look", twoProducers));
    EXPECT_TRUE(model::catches("log_queue_put_over", twoProducers));
    EXPECT_TRUE(model::catches("log_queue_relaxed_give", goingRound));
    EXPECT_TRUE(model::catches("log_queue_relaxed_win", goingRound));
    EXPECT_TRUE(model::catches("log_queue_first_cell_only", goingRound));
}

}  // namespace
