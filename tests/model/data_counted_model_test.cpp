// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>
#include <model/traced_sample.hpp>

#include <rtt/internal/flow/sample_box.cpp>
#include <rtt/internal/flow/detail/data_counted.cpp>

RTT::internal::SampleStore::~SampleStore() = default;
void RTT::internal::SampleStore::grow(const void*, std::size_t) {}  // traced samples have no extent

namespace {

using model::require;
using model::TracedSample;
using model::Trial;
using RTT::internal::SampleStore;

struct Reader {
    int newest = 0;
    std::array<bool, 8> fresh{};
    void read(SampleStore& store, bool oneWriter, bool copyOld = true) {
        TracedSample sample(-1);
        const RTT::FlowStatus status = store.read(&sample, copyOld);
        require(status != RTT::NoData, "there was a sample before");
        const int value = sample.value;
        if (value == -1) {
            require(status == RTT::OldData && !copyOld, "not copied");
            return;
        }
        if (oneWriter) require(value >= newest, "an older sample after a newer one");
        newest = value;
        if (status != RTT::NewData) return;
        require(!fresh[static_cast<std::size_t>(value)], "a sample is new twice for one reader");
        fresh[static_cast<std::size_t>(value)] = true;
    }
};

void write(SampleStore& store, int value) {
    const TracedSample sample(value);
    require(store.write(&sample) == RTT::WriteSuccess, "a write failed");
}

RTT::internal::detail::StorePtr makeStore(std::size_t threads) {
    RTT::internal::StoreSpec spec;
    spec.maxThreads = threads;
    return RTT::internal::detail::makeCountedData(RTT::types::typeOps<TracedSample>(), spec, nullptr);
}

/** Three slots, and writers take the one freed last: where the reader may still be. */
void oneWriter(Trial& trial) {
    const auto store = makeStore(1);
    write(*store, 1);
    Reader reader;
    trial.thread([&] {
        for (int value = 2; value <= 3; ++value) write(*store, value);
    });
    trial.thread([&] {
        reader.read(*store, true);
        reader.read(*store, true);
    });
    trial.go();
    reader.read(*store, true);
    require(reader.newest == 3, "the last sample is lost");
}

void twoReaders(Trial& trial) {
    const auto store = makeStore(2);
    write(*store, 1);
    std::array<Reader, 2> readers;
    trial.thread([&] { write(*store, 2); });
    for (Reader& reader : readers) trial.thread([&] { reader.read(*store, true); });
    trial.go();
    for (std::size_t value = 0; value < 8; ++value)
        require(!readers[0].fresh[value] || !readers[1].fresh[value], "a sample is new for two readers");
}

void twoWriters(Trial& trial) {
    const auto store = makeStore(2);
    write(*store, 1);
    Reader reader;
    trial.thread([&] { write(*store, 2); });
    trial.thread([&] { write(*store, 3); });
    trial.thread([&] { reader.read(*store, false, false); });
    trial.go();
    reader.read(*store, false);
    require(reader.newest == 2 || reader.newest == 3, "the last sample is lost");
}

TEST(CountedData, one_writer_and_one_reader) { EXPECT_TRUE(model::holds(oneWriter)); }
TEST(CountedData, one_writer_and_two_readers) { EXPECT_TRUE(model::holds(twoReaders)); }
TEST(CountedData, two_writers_and_one_reader) { EXPECT_TRUE(model::holds(twoWriters)); }

/** Who asks for new samples only gets none that another reader got. */
void onlyNew(Trial& trial) {
    const auto store = makeStore(2);
    write(*store, 1);
    for (int i = 0; i < 2; ++i)
        trial.thread([&] {
            TracedSample sample(-1);
            const RTT::FlowStatus status = store->read(&sample, false);
            require(status == RTT::NewData ? sample.get() == 1 : sample.get() == -1, "an old sample, not asked for");
        });
    trial.go();
}
TEST(CountedData, only_new_samples) { EXPECT_TRUE(model::holds(onlyNew)); }

/** As PortLink::newest(): by the number of the newest sample, a reader finds out whether it has read it. */
void byNumber(Trial& trial) {
    const auto store = makeStore(1);
    write(*store, 1);
    std::uint64_t seen = 0;
    int got = 0;
    const auto look = [&] {
        std::uint64_t number = store->newest();
        while (number != seen) {
            TracedSample sample(-1);
            (void)store->read(&sample, true);
            require(sample.get() >= got, "an older sample after a newer one");
            got = sample.get();
            const std::uint64_t now = store->newest();
            if (now == number) seen = number;
            number = now;
        }
    };
    trial.thread([&] {
        write(*store, 2);
        write(*store, 3);
    });
    trial.thread([&] { look(); });
    trial.go();
    look();
    require(got == 3, "the last sample is lost");
}
TEST(CountedData, new_samples_by_number) { EXPECT_TRUE(model::holds(byNumber)); }

TEST(CountedData, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("counted_relaxed_turn", byNumber));
    EXPECT_TRUE(model::catches("counted_turn_without_look", byNumber));
    EXPECT_TRUE(model::catches("counted_no_second_look", oneWriter));
    EXPECT_TRUE(model::catches("counted_readers_ignored", oneWriter));
    EXPECT_TRUE(model::catches("counted_relaxed_claim", oneWriter));
    EXPECT_TRUE(model::catches("counted_relaxed_publication", oneWriter));
    EXPECT_TRUE(model::catches("counted_relaxed_unhold", oneWriter));
    EXPECT_TRUE(model::catches("counted_relaxed_visit", oneWriter));
    EXPECT_TRUE(model::catches("counted_relaxed_leave", oneWriter));
    EXPECT_TRUE(model::catches("counted_new_twice", twoReaders));
}

}  // namespace
