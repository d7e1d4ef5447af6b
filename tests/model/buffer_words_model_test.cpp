// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>

#include <rtt/internal/flow/detail/buffer_words.cpp>

#include <model/buffer_scenarios.hpp>

RTT::internal::SampleStore::~SampleStore() = default;

namespace {

using model::atHome;
using model::away;
using model::require;
using model::Trial;
using RTT::internal::SampleStore;
using RTT::internal::StoreSpec;

struct Pair {
    Pair(int value = 0) : first(value), second(value) {}
    int get() const {
        require(first == second, "a torn sample");
        return static_cast<int>(first);
    }
    std::int64_t first, second;
};

std::unique_ptr<SampleStore> make(const StoreSpec& spec) {
    return RTT::internal::detail::makeWordBuffer(RTT::types::typeOps<Pair>(), spec);
}
typedef model::BufferScenarios<Pair, make> Scenarios;

/** clear() while the other reads and writes: each sample comes out at most once, and what came later stays. */
void clearing(Trial& trial) {
    const auto store = Scenarios::makeStore(StoreSpec::Buffer, 2, 2, false);
    Scenarios::Account account;
    account.put(*store, 1);
    trial.thread([&] { store->clear(); });
    trial.thread([&] {
        require(account.put(*store, 2), "refused");
        account.take(*store);
    });
    trial.go();
    account.take(*store);
    account.take(*store);
    require(account.out[1] <= 1 && account.out[2] <= 1, "a sample came twice");
    require(account.put(*store, 3) && account.take(*store) == 3, "unusable afterwards");
}

void twoWrites(Trial& trial) {
    const auto store = Scenarios::makeStore(StoreSpec::Buffer, 2, 0, false);
    Scenarios::Account account;
    trial.thread([&] {
        account.put(*store, 1);
        account.put(*store, 2);
    });
    trial.thread([&] { account.take(*store); });
    trial.go();
    account.settle(*store);
}

TEST(WordBuffer, two_writers_and_one_reader) { EXPECT_TRUE(model::holds(away<Scenarios::twoWritersOneReader>)); }
TEST(WordBuffer, one_writer_and_two_readers) { EXPECT_TRUE(model::holds(away<Scenarios::oneWriterTwoReaders>)); }
TEST(WordBuffer, one_writer_and_one_reader_go_round) { EXPECT_TRUE(model::holds(away<Scenarios::oneWriterOneReader>)); }
TEST(WordBuffer, a_full_circular_buffer) { EXPECT_TRUE(model::holds(away<Scenarios::circular>)); }
TEST(WordBuffer, a_circular_buffer_with_two_writers) { EXPECT_TRUE(model::holds(away<Scenarios::circularTwoWriters>)); }
TEST(WordBuffer, refuses_only_if_full) { EXPECT_TRUE(model::holds(away<Scenarios::refusesOnlyIfFull>)); }
TEST(WordBuffer, old_data) { EXPECT_TRUE(model::holds(away<Scenarios::oldData<5>>)); }
TEST(WordBuffer, a_slot_used_again) { EXPECT_TRUE(model::holds(away<Scenarios::slotReused<8>>)); }
TEST(WordBuffer, clearing) { EXPECT_TRUE(model::holds(away<clearing>)); }

// The same with a writer that has a slot of its own.
TEST(WordBufferAtHome, two_writers_and_one_reader) {
    EXPECT_TRUE(model::holds(atHome<1, Scenarios::twoWritersOneReader>));
}
TEST(WordBufferAtHome, one_writer_and_two_readers) {
    EXPECT_TRUE(model::holds(atHome<1, Scenarios::oneWriterTwoReaders>));
}
TEST(WordBufferAtHome, one_writer_and_one_reader_go_round) {
    EXPECT_TRUE(model::holds(atHome<1, Scenarios::oneWriterOneReader>));
}
TEST(WordBufferAtHome, a_full_circular_buffer) { EXPECT_TRUE(model::holds(atHome<1, Scenarios::circular>)); }
TEST(WordBufferAtHome, a_circular_buffer_with_two_writers) {
    EXPECT_TRUE(model::holds(atHome<2, Scenarios::circularTwoWriters>));
}
TEST(WordBufferAtHome, refuses_only_if_full) { EXPECT_TRUE(model::holds(atHome<2, Scenarios::refusesOnlyIfFull>)); }
TEST(WordBufferAtHome, old_data) { EXPECT_TRUE(model::holds(atHome<1, Scenarios::oldData<5>>)); }
TEST(WordBufferAtHome, a_slot_used_again) { EXPECT_TRUE(model::holds(atHome<1, Scenarios::slotReused<8>>)); }
TEST(WordBufferAtHome, clearing) { EXPECT_TRUE(model::holds(atHome<2, clearing>)); }

TEST(WordBuffer, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("words_relaxed_words", away<Scenarios::oldData<5>>));
    EXPECT_TRUE(model::catches("words_relaxed_copy", away<Scenarios::oldData<5>>));
    EXPECT_TRUE(model::catches("words_relaxed_enter", away<Scenarios::oneWriterOneReader>));
    EXPECT_TRUE(model::catches("words_taken_twice", away<Scenarios::oneWriterTwoReaders>));
    EXPECT_TRUE(model::catches("words_overwritten", away<Scenarios::twoWritersOneReader>));
    EXPECT_TRUE(model::catches("words_relaxed_tail", away<Scenarios::refusesOnlyIfFull>));
    EXPECT_TRUE(model::catches("words_spare_kept", atHome<1, twoWrites>));
    EXPECT_TRUE(model::catches("words_old_not_checked", away<Scenarios::oldData<5>>));
}

}  // namespace
