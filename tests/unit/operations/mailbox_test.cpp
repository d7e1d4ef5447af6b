// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/engine/mailbox.hpp>

#include <gtest/gtest.h>

#include <thread>
#include <vector>

using RTT::internal::Mailbox;

namespace {

void* item(std::uintptr_t number) { return reinterpret_cast<void*>(number << 2); }
std::uintptr_t numberOf(const Mailbox::Item& taken) { return reinterpret_cast<std::uintptr_t>(taken.what) >> 2; }

TEST(Mailbox, GivesItemsInOrder) {
    Mailbox box;
    EXPECT_TRUE(box.empty());
    for (std::uintptr_t i = 1; i != 4; ++i) EXPECT_TRUE(box.put({Mailbox::Kind::Message, item(i)}));
    EXPECT_FALSE(box.empty());
    Mailbox::Item taken;
    for (std::uintptr_t i = 1; i != 4; ++i) {
        ASSERT_TRUE(box.take(taken));
        EXPECT_EQ(numberOf(taken), i);
    }
    EXPECT_FALSE(box.take(taken));
    EXPECT_TRUE(box.empty());
}

TEST(Mailbox, RefusesWhatDoesNotFitAndGoesOnAfterwards) {
    Mailbox box;
    Mailbox::Item taken;
    for (int round = 0; round != 3; ++round) {
        for (std::size_t i = 0; i != Mailbox::kCapacity; ++i) ASSERT_TRUE(box.put({Mailbox::Kind::Port, item(i + 1)}));
        EXPECT_FALSE(box.put({Mailbox::Kind::Port, item(9999)}));
        for (std::size_t i = 0; i != Mailbox::kCapacity; ++i) {
            ASSERT_TRUE(box.take(taken));
            EXPECT_EQ(numberOf(taken), i + 1);
        }
        EXPECT_FALSE(box.take(taken));
    }
}

// Each producer's items arrive once and in its order, whoever takes them.
void storm(unsigned producers, unsigned consumers, std::uintptr_t each) {
    Mailbox box;
    std::atomic<std::uintptr_t> taken{0};
    std::vector<std::vector<std::uintptr_t>> received(consumers);
    std::vector<std::thread> threads;
    for (unsigned p = 0; p != producers; ++p)
        threads.emplace_back([&, p] {
            for (std::uintptr_t i = 1; i <= each; ++i)
                while (!box.put({Mailbox::Kind::Message, item((std::uintptr_t(p) << 32) | i)}))
                    std::this_thread::yield();
        });
    for (unsigned c = 0; c != consumers; ++c)
        threads.emplace_back([&, c] {
            Mailbox::Item one;
            while (taken.load() != producers * each) {
                if (box.take(one)) {
                    received[c].push_back(numberOf(one));
                    ++taken;
                } else {
                    std::this_thread::yield();
                }
            }
        });
    for (std::thread& thread : threads) thread.join();

    std::size_t total = 0;
    for (const auto& mine : received) {
        std::vector<std::uintptr_t> last(producers, 0);
        for (const std::uintptr_t number : mine) {
            EXPECT_GT(number & 0xffffffffu, last[number >> 32]);
            last[number >> 32] = number & 0xffffffffu;
        }
        total += mine.size();
    }
    EXPECT_EQ(total, producers * each);
}

TEST(MailboxStress, ManyProducersOneConsumer) { storm(4, 1, 20000); }
TEST(MailboxStress, ManyProducersManyConsumers) { storm(3, 3, 20000); }

}  // namespace
