// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>
#include <model/traced_sample.hpp>

#include <rtt/internal/flow/sample_box.cpp>
#include <rtt/internal/flow/detail/buffer_lock_free.cpp>
#include <rtt/internal/flow/detail/buffer_parted.cpp>

#include <model/buffer_scenarios.hpp>

RTT::internal::SampleStore::~SampleStore() = default;
void RTT::internal::SampleStore::grow(const void*, std::size_t) {}  // traced samples have no extent

namespace {

using model::TracedSample;
using model::Trial;
using RTT::internal::SampleStore;
using RTT::internal::StoreSpec;

/** Has its clock and its writers' processors beside it. */
class Store final : public SampleStore {
public:
    explicit Store(const StoreSpec& spec)
        : SampleStore(RTT::types::typeOps<TracedSample>()),
          store_(new RTT::internal::detail::PartedBuffer(ops(), spec, nullptr, 2)) {
        RTT::internal::detail::writerPlaces = &places_;
    }
    void divide() { store_->state_.fetch_or(RTT::internal::detail::PartedBuffer::kOfProcessors); }
    RTT::WriteStatus write(const void* sample) override { return store_->write(sample); }
    RTT::FlowStatus read(void* sample, bool copyOld) override { return store_->read(sample, copyOld); }
    void clear() override { store_->clear(); }
    std::size_t size() const override { return store_->size(); }

private:
    void resizeElements(const void*, bool) override {}
    RTT::internal::detail::WriterPlaces places_;
    std::unique_ptr<RTT::internal::detail::PartedBuffer> store_;
};

/** Before writers take turns. */
std::unique_ptr<SampleStore> makeFirst(const StoreSpec& spec) { return std::unique_ptr<SampleStore>(new Store(spec)); }
typedef model::BufferScenarios<TracedSample, makeFirst> First;

std::unique_ptr<SampleStore> make(const StoreSpec& spec) {
    std::unique_ptr<Store> store(new Store(spec));
    store->divide();
    return store;
}
typedef model::BufferScenarios<TracedSample, make> Scenarios;

/** The samples of a thread come out in their order, whatever parts they went through. */
template <class S>
void orderOfAThread(Trial& trial) {
    const auto store = S::makeStore(StoreSpec::Buffer, 4, 1, false);
    Scenarios::Account account;
    trial.thread([&] {
        for (int value = 1; value <= 3; ++value) model::require(account.put(*store, value), "refused");
    });
    int last = 0;
    trial.thread([&] {
        for (int i = 0; i < 3; ++i) {
            const int value = account.take(*store);
            model::require(value == 0 || value == last + 1, "not in order");
            if (value != 0) last = value;
        }
    });
    trial.go();
    account.settle(*store);
}

/** So do those of two threads, one of which waits for the other. */
void orderOfThreads(Trial& trial) {
    const auto store = Scenarios::makeStore(StoreSpec::Buffer, 4, 2, false);
    Scenarios::Account account;
    std::atomic<bool> first{false};
    trial.thread([&] {
        model::require(account.put(*store, 1), "refused");
        first.store(true, std::memory_order_release);
    });
    trial.thread([&] {
        if (first.load(std::memory_order_acquire)) model::require(account.put(*store, 2), "refused");
    });
    int got = 0;
    trial.thread([&] { got = account.take(*store); });
    trial.go();
    model::require(got != 2, "the later one came first");
    account.settle(*store);
}

/** A writer finds its part full, a reader makes room there, and the other part is full when the writer comes to it. */
void refusesOnlyIfAllAreFull(Trial& trial) {
    const auto store = Scenarios::makeStore(StoreSpec::Buffer, 2, 3, false);
    for (int value = 1; value <= 2; ++value) model::require(Scenarios::write(*store, value), "not set up");
    model::require(Scenarios::readNew(*store) == 1 && Scenarios::write(*store, 3), "not set up");
    model::require(!Scenarios::write(*store, 4) && Scenarios::readNew(*store) == 2, "not set up");
    // Part 0 is full, and the next writer is there.
    trial.thread([&] {
        Scenarios::readNew(*store);
        Scenarios::write(*store, 5);
    });
    bool done = false;
    trial.thread([&] { done = Scenarios::write(*store, 6); });
    trial.go();
    model::require(done, "refused by a buffer that never was full");
}

/** The parts come into use while a thread writes and another one reads. */
void orderWhenThePartsComeIntoUse(Trial& trial) {
    const auto store = First::makeStore(StoreSpec::Buffer, 3, 1, false);
    auto& parted = static_cast<Store&>(*store);
    Scenarios::Account account;
    trial.thread([&] {
        for (int value = 1; value <= 2; ++value) model::require(account.put(*store, value), "refused");
    });
    trial.thread([&] { parted.divide(); });
    int last = 0;
    trial.thread([&] {
        for (int i = 0; i < 2; ++i) {
            const int value = account.take(*store);
            model::require(value == 0 || value == last + 1, "not in order");
            if (value != 0) last = value;
        }
    });
    trial.go();
    account.settle(*store);
}

TEST(PartedBuffer, two_writers_and_one_reader) { EXPECT_TRUE(model::holds(Scenarios::twoWritersOneReader)); }
TEST(PartedBuffer, one_writer_and_two_readers) { EXPECT_TRUE(model::holds(Scenarios::oneWriterTwoReaders)); }
TEST(PartedBuffer, one_writer_and_one_reader_go_round) { EXPECT_TRUE(model::holds(Scenarios::oneWriterOneReader)); }
TEST(PartedBuffer, refuses_only_if_full) { EXPECT_TRUE(model::holds(Scenarios::refusesOnlyIfFull)); }
TEST(PartedBuffer, refuses_only_if_all_parts_are_full) { EXPECT_TRUE(model::holds(refusesOnlyIfAllAreFull)); }
TEST(PartedBuffer, old_data) { EXPECT_TRUE(model::holds(Scenarios::oldData<1>)); }
TEST(PartedBuffer, order_of_a_thread) { EXPECT_TRUE(model::holds(orderOfAThread<Scenarios>)); }
TEST(PartedBuffer, order_of_threads) { EXPECT_TRUE(model::holds(orderOfThreads)); }
TEST(PartedBuffer, order_when_the_parts_come_into_use) { EXPECT_TRUE(model::holds(orderWhenThePartsComeIntoUse)); }

TEST(PartedBuffer, first_one_writer_and_two_readers) { EXPECT_TRUE(model::holds(First::oneWriterTwoReaders)); }
TEST(PartedBuffer, first_one_writer_and_one_reader) { EXPECT_TRUE(model::holds(First::oneWriterOneReader)); }
TEST(PartedBuffer, first_refuses_only_if_full) { EXPECT_TRUE(model::holds(First::refusesOnlyIfFull)); }
TEST(PartedBuffer, first_order_of_a_thread) { EXPECT_TRUE(model::holds(orderOfAThread<First>)); }

TEST(PartedBuffer, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("parted_not_looked_again", orderOfAThread<Scenarios>));
    EXPECT_TRUE(model::catches("parted_refused_too_soon", refusesOnlyIfAllAreFull));
    EXPECT_TRUE(model::catches("parted_other_parts_not_tried", refusesOnlyIfAllAreFull));
    EXPECT_TRUE(model::catches("parted_relaxed_enter", Scenarios::oneWriterTwoReaders));
    EXPECT_TRUE(model::catches("parted_taken_twice", Scenarios::oneWriterTwoReaders));
}

}  // namespace
