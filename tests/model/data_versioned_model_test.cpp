// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>

#include <rtt/internal/flow/sample_box.cpp>
#include <rtt/internal/flow/detail/data_versioned.cpp>

RTT::internal::SampleStore::~SampleStore() = default;

namespace {

using model::atHome;
using model::away;
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

/** Once round its slots and on. */
void oneHomeWriter(Trial& trial) {
    const auto store = makeStore(0);
    write(*store, 1);
    Reader reader;
    trial.thread([&] {
        for (std::uint64_t value = 2; value <= 5; ++value) write(*store, value);
    });
    trial.thread([&] { reader.read(*store, true); });
    trial.go();
    reader.read(*store, true);
    require(reader.newest == 5, "the last sample is lost");
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

TEST(VersionedData, one_writer_and_one_reader) { EXPECT_TRUE(model::holds(away<oneWriter>)); }
TEST(VersionedData, one_writer_and_two_readers) { EXPECT_TRUE(model::holds(away<twoReaders>)); }
TEST(VersionedData, two_writers_and_one_reader) { EXPECT_TRUE(model::holds(away<twoWriters>)); }

// The same with a reader that takes samples by plain stores.
TEST(VersionedDataAlone, one_writer_and_one_reader) { EXPECT_TRUE(model::holds(model::alone<away<oneWriter>>)); }
TEST(VersionedDataAlone, two_writers_and_one_reader) { EXPECT_TRUE(model::holds(model::alone<away<twoWriters>>)); }

// The same with a writer that has slots of its own.
TEST(VersionedDataAtHome, one_writer_and_one_reader) { EXPECT_TRUE(model::holds(atHome<1, oneHomeWriter>)); }
TEST(VersionedDataAtHome, one_writer_and_two_readers) { EXPECT_TRUE(model::holds(atHome<1, twoReaders>)); }
TEST(VersionedDataAtHome, two_writers_and_one_reader) { EXPECT_TRUE(model::holds(atHome<1, twoWriters>)); }

TEST(VersionedData, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("versioned_no_second_look", away<oneWriter>));
    EXPECT_TRUE(model::catches("versioned_relaxed_words", away<oneWriter>));
    EXPECT_TRUE(model::catches("versioned_relaxed_copy", away<oneWriter>));
    EXPECT_TRUE(model::catches("versioned_relaxed_publication", away<oneWriter>));
    EXPECT_TRUE(model::catches("versioned_new_twice", away<twoReaders>));
    EXPECT_TRUE(model::catches("versioned_never_taken", model::alone<away<oneWriter>>));
    EXPECT_TRUE(model::catches("versioned_current_overwritten", away<twoWriters>));
    EXPECT_TRUE(model::catches("versioned_relaxed_owner", away<twoWriters>));
    EXPECT_TRUE(model::catches("versioned_home_not_in_turn", atHome<1, oneHomeWriter>));
}

}  // namespace
