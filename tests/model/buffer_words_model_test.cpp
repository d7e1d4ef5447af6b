// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>

#include <rtt/internal/detail/buffer_words.cpp>

#include <model/buffer_scenarios.hpp>

RTT::internal::SampleStore::~SampleStore() = default;

namespace {

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

TEST(WordBuffer, two_writers_and_one_reader) { EXPECT_TRUE(model::holds(Scenarios::twoWritersOneReader)); }
TEST(WordBuffer, one_writer_and_two_readers) { EXPECT_TRUE(model::holds(Scenarios::oneWriterTwoReaders)); }
TEST(WordBuffer, one_writer_and_one_reader_go_round) { EXPECT_TRUE(model::holds(Scenarios::oneWriterOneReader)); }
TEST(WordBuffer, a_full_circular_buffer) { EXPECT_TRUE(model::holds(Scenarios::circular)); }
TEST(WordBuffer, old_data) { EXPECT_TRUE(model::holds(Scenarios::oldData<3>)); }
TEST(WordBuffer, a_slot_used_again) { EXPECT_TRUE(model::holds(Scenarios::slotReused)); }
TEST(WordBuffer, clearing) { EXPECT_TRUE(model::holds(clearing)); }

TEST(WordBuffer, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("words_relaxed_words", Scenarios::oldData<3>));
    EXPECT_TRUE(model::catches("words_relaxed_copy", Scenarios::oldData<3>));
    EXPECT_TRUE(model::catches("words_relaxed_enter", Scenarios::oneWriterOneReader));
    EXPECT_TRUE(model::catches("words_taken_twice", Scenarios::oneWriterTwoReaders));
    EXPECT_TRUE(model::catches("words_overwritten", Scenarios::twoWritersOneReader));
    EXPECT_TRUE(model::catches("words_old_not_checked", Scenarios::oldData<3>));
}

}  // namespace
