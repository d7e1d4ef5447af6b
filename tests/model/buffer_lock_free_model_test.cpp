// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>
#include <model/traced_sample.hpp>

#include <rtt/internal/flow/sample_box.cpp>
#include <rtt/internal/flow/detail/buffer_lock_free.cpp>

#include <model/buffer_scenarios.hpp>

RTT::internal::SampleStore::~SampleStore() = default;
void RTT::internal::SampleStore::grow(const void*, std::size_t) {}  // traced samples have no extent

namespace {

using model::TracedSample;
using model::Trial;
using RTT::internal::SampleStore;
using RTT::internal::StoreSpec;

std::unique_ptr<SampleStore> make(const StoreSpec& spec) {
    return RTT::internal::detail::makeLockFreeBuffer(RTT::types::typeOps<TracedSample>(), spec, nullptr);
}
typedef model::BufferScenarios<TracedSample, make> Scenarios;

/** A reader has found the last sample when another thread replaces it and uses its slot again. */
void lastReused(Trial& trial) {
    const auto store = Scenarios::makeStore(StoreSpec::Buffer, 1, 0, true);
    model::require(Scenarios::write(*store, 1) && Scenarios::readNew(*store) == 1, "not set up");
    auto& buffer = static_cast<RTT::internal::detail::LockFreeBuffer&>(*store);
    trial.thread([&] {
        for (int value = 2; value <= 4; ++value)
            if (Scenarios::write(*store, value))
                model::require(Scenarios::readNew(*store) == value, "somebody else took it");
    });
    trial.thread([&] {
        TracedSample sample(-1);
        if (buffer.readLast(&sample, true) >= 0) model::require(sample.get() >= 1, "no old sample");
    });
    trial.go();
}

TEST(LockFreeBuffer, two_writers_and_one_reader) { EXPECT_TRUE(model::holds(Scenarios::twoWritersOneReader)); }
TEST(LockFreeBuffer, one_writer_and_two_readers) { EXPECT_TRUE(model::holds(Scenarios::oneWriterTwoReaders)); }
TEST(LockFreeBuffer, one_writer_and_one_reader_go_round) { EXPECT_TRUE(model::holds(Scenarios::oneWriterOneReader)); }
TEST(LockFreeBuffer, a_full_circular_buffer) { EXPECT_TRUE(model::holds(Scenarios::circular)); }
TEST(LockFreeBuffer, a_circular_buffer_with_two_writers) { EXPECT_TRUE(model::holds(Scenarios::circularTwoWriters)); }
TEST(LockFreeBuffer, refuses_only_if_full) { EXPECT_TRUE(model::holds(Scenarios::refusesOnlyIfFull)); }
TEST(LockFreeBuffer, old_data) { EXPECT_TRUE(model::holds(Scenarios::oldData<2>)); }
TEST(LockFreeBuffer, the_last_sample_while_its_slot_is_used_again) { EXPECT_TRUE(model::holds(lastReused)); }
TEST(LockFreeBuffer, a_slot_used_again) { EXPECT_TRUE(model::holds(Scenarios::slotReused<6>)); }

TEST(LockFreeBuffer, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("buffer_relaxed_enter", Scenarios::oneWriterTwoReaders));
    EXPECT_TRUE(model::catches("buffer_relaxed_take", Scenarios::oneWriterTwoReaders));
    EXPECT_TRUE(model::catches("buffer_taken_twice", Scenarios::oneWriterTwoReaders));
    EXPECT_TRUE(model::catches("buffer_overwritten", Scenarios::twoWritersOneReader));
    EXPECT_TRUE(model::catches("buffer_tail_not_helped", Scenarios::twoWritersOneReader));
    EXPECT_TRUE(model::catches("buffer_relaxed_release", Scenarios::oneWriterOneReader));
    EXPECT_TRUE(model::catches("buffer_relaxed_claim", Scenarios::oneWriterOneReader));
    EXPECT_TRUE(model::catches("buffer_last_not_checked", lastReused));
}

}  // namespace
