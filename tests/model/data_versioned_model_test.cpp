// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>

#include <rtt/internal/SampleBox.cpp>
#include <rtt/internal/detail/data_versioned.cpp>

RTT::internal::SampleStore::~SampleStore() = default;

namespace {

using model::require;
using model::Trial;
using RTT::internal::SampleStore;

struct Pair {
    std::uint64_t first = 0, second = 0;
};

/** What one reader got. Samples are written in rising order unless there are several writers. */
struct Reader {
    std::uint64_t newest = 0;
    std::array<bool, 8> fresh{};
    void read(SampleStore& store, bool oneWriter) {
        Pair pair;
        const RTT::FlowStatus status = store.read(&pair, true);
        require(status != RTT::NoData, "there was a sample before");
        require(pair.first == pair.second, "a torn sample");
        if (oneWriter) require(pair.first >= newest, "an older sample after a newer one");
        newest = pair.first;
        if (status != RTT::NewData) return;
        require(!fresh[pair.first], "a sample is new twice for one reader");
        fresh[pair.first] = true;
    }
};

void write(SampleStore& store, std::uint64_t value) {
    const Pair pair{value, value};
    require(store.write(&pair) == RTT::WriteSuccess, "a write failed");
}

RTT::internal::detail::StorePtr makeStore(std::size_t threads) {
    RTT::internal::StoreSpec spec;
    spec.maxThreads = threads;
    return RTT::internal::detail::makeVersionedData(RTT::types::typeOps<Pair>(), spec);
}

/** Two slots only: the second write goes where the reader may still be. */
void oneWriter(Trial& trial) {
    const auto store = makeStore(0);
    write(*store, 1);
    Reader reader;
    trial.thread([&] {
        write(*store, 2);
        write(*store, 3);
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
    const auto store = makeStore(1);
    write(*store, 1);
    std::array<Reader, 2> readers;
    trial.thread([&] { write(*store, 2); });
    for (Reader& reader : readers) trial.thread([&] { reader.read(*store, true); });
    trial.go();
    for (int value = 0; value < 8; ++value)
        require(!readers[0].fresh[value] || !readers[1].fresh[value], "a sample is new for two readers");
}

void twoWriters(Trial& trial) {
    const auto store = makeStore(1);
    write(*store, 1);
    Reader reader;
    trial.thread([&] { write(*store, 2); });
    trial.thread([&] { write(*store, 3); });
    trial.thread([&] { reader.read(*store, false); });
    trial.go();
    reader.read(*store, false);
    require(reader.newest == 2 || reader.newest == 3, "the last sample is lost");
}

TEST(VersionedData, one_writer_and_one_reader) { EXPECT_TRUE(model::holds(oneWriter)); }
TEST(VersionedData, one_writer_and_two_readers) { EXPECT_TRUE(model::holds(twoReaders)); }
TEST(VersionedData, two_writers_and_one_reader) { EXPECT_TRUE(model::holds(twoWriters)); }

TEST(VersionedData, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("versioned_no_second_look", oneWriter));
    EXPECT_TRUE(model::catches("versioned_relaxed_words", oneWriter));
    EXPECT_TRUE(model::catches("versioned_relaxed_copy", oneWriter));
    EXPECT_TRUE(model::catches("versioned_relaxed_publication", oneWriter));
    EXPECT_TRUE(model::catches("versioned_new_twice", twoReaders));
    EXPECT_TRUE(model::catches("versioned_current_overwritten", twoWriters));
    EXPECT_TRUE(model::catches("versioned_relaxed_owner", twoWriters));
}

}  // namespace
