// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/expect.hpp>
#include <model/checker/substitute.hpp>

#include <rtt/internal/flow/detail/sole_reader.hpp>

namespace {

using model::require;
using model::Trial;
using RTT::internal::detail::SoleReader;

/** What readers of a store take: samples, each of which is new for one of them. */
struct Store {
    const int samples;
    SoleReader reader;
    std::atomic<int> taken{0};
    model::Plain<int> last{0};
    int fresh[4] = {};

    /** Thread 1 reads alone already, or does so after one more read. */
    Store(bool decided, int samples) : samples(samples) {
        const void* const first = &RTT::internal::detail::threads[1];
        if (decided) {
            reader.thread_ = first;
        } else {
            reader.last_ = first;
            reader.inARow_ = SoleReader::kInARow - 1;
        }
    }
    void read() {
        const SoleReader::Reading reading(reader);
        int seen = taken.load(std::memory_order_acquire);
        if (seen == samples || reading.late()) return;
        require(last <= seen, "a sample is forgotten");
        if (reading.alone())
            taken.store(seen + 1, std::memory_order_release);
        else if (!taken.compare_exchange_strong(seen, seen + 1, std::memory_order_acq_rel))
            return;
        if (reading.alone()) last = seen + 1;
        ++fresh[model::self()];
    }
    int takenTimes() const { return fresh[0] + fresh[1] + fresh[2] + fresh[3]; }
};

template <bool decided, int samples, int readsOfFirst>
void readers(Trial& trial) {
    Store store(decided, samples);
    trial.thread([&] {
        for (int i = 0; i != readsOfFirst; ++i) store.read();
    });
    trial.thread([&] { store.read(); });
    trial.go();
    // A reader that was late has left it to the next one.
    for (int i = 0; i != samples; ++i) store.read();
    require(store.takenTimes() == samples, "a sample is new for none, or for two readers");
}

/** A thread that has come stops before its barrier, and one more comes. */
void aThreadStops(Trial& trial) {
    Store store(true, 1);
    trial.thread([&] { store.read(); });
    trial.thread([&] { store.reader.thread_ = SoleReader::ending(); });
    trial.thread([&] { store.read(); });
    trial.go();
    store.read();
    require(store.takenTimes() == 1, "a sample is new for none, or for two readers");
}

TEST(SoleReader, another_one_comes) { EXPECT_TRUE(model::holds(readers<true, 2, 2>)); }
TEST(SoleReader, one_of_two_that_come_stops) { EXPECT_TRUE(model::holds(aThreadStops)); }
TEST(SoleReader, another_one_is_inside_when_it_is_decided) { EXPECT_TRUE(model::holds(readers<false, 2, 2>)); }

TEST(SoleReader, planted_faults_are_found) {
    EXPECT_TRUE(model::catches("sole_not_asked_again", readers<true, 2, 1>));
    EXPECT_TRUE(model::catches("sole_without_barrier", readers<true, 2, 1>));
    EXPECT_TRUE(model::catches("sole_shared_too_early", aThreadStops));
    EXPECT_TRUE(model::catches("sole_late_is_ignored", readers<true, 2, 1>));
    EXPECT_TRUE(model::catches("sole_relaxed_end", readers<true, 2, 1>));
    EXPECT_TRUE(model::catches("sole_inside_uncounted", readers<false, 2, 2>));
}

}  // namespace
