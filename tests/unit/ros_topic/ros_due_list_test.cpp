// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Threads that write at once, and the one that sends: nothing written is forgotten, and all publishers are let go.
#include <rtt_roscomm/detail/due_publisher.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include <boost/smart_ptr/intrusive_ptr.hpp>

namespace {

using rtt_roscomm::detail::DueList;
using rtt_roscomm::detail::DuePublisher;

struct Counted : DuePublisher {
    explicit Counted(std::atomic<int>& alive) : alive(alive) { ++alive; }
    ~Counted() override { --alive; }
    void publishDue() override { sent = written.load(); }
    std::atomic<int>& alive;
    std::atomic<int> written{0}, sent{0};
};
typedef boost::intrusive_ptr<Counted> Pointer;

TEST(RosDueList, ComesInTheOrderInWhichTheyWereAddedAndOnce) {
    std::atomic<int> alive{0};
    DueList list;
    const Pointer a(new Counted(alive)), b(new Counted(alive));
    EXPECT_TRUE(list.add(*b));
    EXPECT_TRUE(list.add(*a));
    EXPECT_FALSE(list.add(*b));
    std::vector<DuePublisher*> taken;
    list.takeAll([&](DuePublisher& one) { taken.push_back(&one); });
    EXPECT_EQ((std::vector<DuePublisher*>{b.get(), a.get()}), taken);
    EXPECT_TRUE(list.add(*b));
    list.takeAll([](DuePublisher&) {});
}

TEST(RosDueList, NothingWrittenIsForgotten) {
    constexpr int kWrites = 20000;
    std::atomic<int> alive{0};
    DueList list;
    {
        std::vector<Pointer> all;
        for (int i = 0; i != 4; ++i) all.emplace_back(new Counted(alive));
        std::atomic<bool> isOver{false};
        std::thread taker([&] {
            const auto visit = [](DuePublisher& one) { one.publishDue(); };
            while (!isOver) list.takeAll(visit);
            list.takeAll(visit);
        });
        std::vector<std::thread> writers;
        for (int thread = 0; thread != 3; ++thread)
            writers.emplace_back([&, thread] {
                for (int i = 0; i != kWrites; ++i) {
                    Counted& one = *all[static_cast<std::size_t>(i + thread) % all.size()];
                    ++one.written;
                    list.add(one);
                }
            });
        for (std::thread& writer : writers) writer.join();
        isOver = true;
        taker.join();
        for (const Pointer& one : all) EXPECT_EQ(one->written, one->sent);
    }
    EXPECT_EQ(0, alive);
}

TEST(RosDueList, APublisherThatIsLetGoLivesUntilItIsVisited) {
    std::atomic<int> alive{0};
    DueList list;
    Pointer one(new Counted(alive));
    list.add(*one);
    one.reset();
    EXPECT_EQ(1, alive);
    list.takeAll([](DuePublisher& last) { last.publishDue(); });
    EXPECT_EQ(0, alive);
}

}  // namespace
