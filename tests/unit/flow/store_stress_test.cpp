// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Many writers and readers on one storage: nothing torn, nothing twice, nothing out of order, nothing lost where the
// policy forbids it.
#include "samples.hpp"

#include <rtt/internal/flow/sample_store.hpp>
#include <rtt/types/TypeOps.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

using namespace RTT;
using namespace flow_test;
using internal::SampleStore;
using internal::StoreSpec;

namespace {

constexpr std::uint64_t kWriters = 3, kReaders = 3;

struct Result {
    std::uint64_t got = 0, torn = 0, disordered = 0, afterNew = 0;
    std::vector<std::uint64_t> serials[kWriters];
};

/** Reads until the writers are done and there is nothing new. */
template <class S>
Result readAll(SampleStore& store, const std::atomic<unsigned>& writing, bool record) {
    Result result;
    S sample;
    std::uint64_t last[kWriters] = {};
    for (;;) {
        const bool done = writing.load() == 0;
        const FlowStatus status = store.read(&sample, true);
        if (status == NoData) {
            if (done) return result;
            std::this_thread::yield();
            continue;
        }
        if (!intact(sample) || sample.writer >= kWriters) {
            ++result.torn;
            continue;
        }
        if (status == OldData) {
            if (done) return result;
            std::this_thread::yield();  // or writers wait for a time slice whenever the buffer is empty
            continue;
        }
        ++result.got;
        if (sample.serial <= last[sample.writer]) ++result.disordered;
        last[sample.writer] = sample.serial;
        if (record) result.serials[sample.writer].push_back(sample.serial);
    }
}

template <class S>
class Storm {
public:
    explicit Storm(StoreSpec spec) {
        spec.maxThreads = kWriters + kReaders;
        store = SampleStore::make(types::typeOps<S>(), spec, nullptr);
    }

    /** With `insist` a writer repeats what is refused. */
    void run(std::uint64_t each, bool insist, bool record) {
        std::atomic<unsigned> writing{kWriters};
        std::vector<std::thread> threads;
        results.resize(kReaders);
        for (std::uint64_t w = 0; w < kWriters; ++w)
            threads.emplace_back([=, this_ = this, &writing] {
                S sample;
                for (std::uint64_t n = 1; n <= each; ++n) {
                    fill(sample, w, n);
                    while (this_->store->write(&sample) != WriteSuccess) {
                        ++this_->refused;
                        if (!insist) break;
                        std::this_thread::yield();
                    }
                }
                --writing;
            });
        for (std::uint64_t r = 0; r < kReaders; ++r)
            threads.emplace_back(
                [=, this_ = this, &writing] { this_->results[r] = readAll<S>(*this_->store, writing, record); });
        for (std::thread& t : threads) t.join();
    }

    void expectIntact() const {
        for (const Result& r : results) {
            EXPECT_EQ(r.torn, 0u);
            EXPECT_EQ(r.disordered, 0u);
        }
    }
    std::uint64_t total() const {
        std::uint64_t sum = 0;
        for (const Result& r : results) sum += r.got;
        return sum;
    }
    void expectEachOnce(std::uint64_t each) const {
        for (std::uint64_t w = 0; w < kWriters; ++w) {
            std::vector<unsigned> seen(each + 1, 0);
            for (const Result& r : results)
                for (const std::uint64_t serial : r.serials[w]) ++seen.at(serial);
            for (std::uint64_t n = 1; n <= each; ++n) ASSERT_EQ(seen[n], 1u) << "writer " << w << " sample " << n;
        }
    }

    std::unique_ptr<SampleStore> store;
    std::vector<Result> results;
    std::atomic<std::uint64_t> refused{0};
};

StoreSpec spec(StoreSpec::Kind kind, StoreSpec::Lock lock) {
    StoreSpec s;
    s.kind = kind;
    s.lock = lock;
    s.size = 7;
    return s;
}

template <class S>
void stormOnData(StoreSpec::Lock lock) {
    Storm<S> storm(spec(StoreSpec::Data, lock));
    const std::uint64_t each = stressCount(20000);
    storm.run(each, false, true);
    storm.expectIntact();
    EXPECT_EQ(storm.refused, 0u);
    EXPECT_LE(storm.total(), each * kWriters);
    // No sample is new for two readers.
    for (std::uint64_t w = 0; w < kWriters; ++w) {
        std::vector<unsigned> seen(each + 1, 0);
        for (const Result& r : storm.results)
            for (const std::uint64_t serial : r.serials[w]) ASSERT_LE(++seen.at(serial), 1u);
    }
}

template <class S>
void stormOnBuffer(StoreSpec::Lock lock) {
    Storm<S> storm(spec(StoreSpec::Buffer, lock));
    const std::uint64_t each = stressCount(10000);
    storm.run(each, true, true);
    storm.expectIntact();
    EXPECT_EQ(storm.total(), each * kWriters);
    EXPECT_EQ(storm.store->dropped(), storm.refused);
    storm.expectEachOnce(each);
}

template <class S>
void stormOnCircular(StoreSpec::Lock lock) {
    Storm<S> storm(spec(StoreSpec::CircularBuffer, lock));
    const std::uint64_t each = stressCount(10000);
    storm.run(each, false, false);
    storm.expectIntact();
    EXPECT_EQ(storm.refused, 0u);
    EXPECT_EQ(storm.total() + storm.store->dropped(), each * kWriters);
}

}  // namespace

TEST(StoreStress, LockFreeDataOfPlainSamples) { stormOnData<Plain>(StoreSpec::LockFree); }
TEST(StoreStress, LockFreeDataOfDeepSamples) { stormOnData<Deep>(StoreSpec::LockFree); }
TEST(StoreStress, LockedData) { stormOnData<Deep>(StoreSpec::Locked); }
TEST(StoreStress, LockFreeBufferOfPlainSamples) { stormOnBuffer<Plain>(StoreSpec::LockFree); }
TEST(StoreStress, LockFreeBufferOfDeepSamples) { stormOnBuffer<Deep>(StoreSpec::LockFree); }
TEST(StoreStress, LockedBuffer) { stormOnBuffer<Deep>(StoreSpec::Locked); }
TEST(StoreStress, LockFreeCircularBufferOfPlainSamples) { stormOnCircular<Plain>(StoreSpec::LockFree); }
TEST(StoreStress, LockFreeCircularBufferOfDeepSamples) { stormOnCircular<Deep>(StoreSpec::LockFree); }
TEST(StoreStress, LockedCircularBuffer) { stormOnCircular<Deep>(StoreSpec::Locked); }

TEST(StoreStress, SizingAndClearingDuringTraffic) {
    for (const StoreSpec::Kind kind : {StoreSpec::Data, StoreSpec::CircularBuffer}) {
        Storm<Deep> storm(spec(kind, StoreSpec::LockFree));
        std::atomic<bool> stop{false};
        std::thread sizer([&] {
            Deep sizing;
            fill(sizing, 0, 0);
            while (!stop) {
                storm.store->setSample(&sizing, true);
                storm.store->clear();
                std::this_thread::yield();
            }
        });
        storm.run(stressCount(3000), false, false);
        stop = true;
        sizer.join();
        for (const Result& r : storm.results) EXPECT_EQ(r.torn, 0u);
    }
}

// The first reader has long been the only one, and takes samples without asking whether others do.
TEST(StoreStress, SecondReaderComesToOneThatReadsAlone) {
    for (std::uint64_t round = stressCount(100); round != 0; --round) {
        constexpr std::uint64_t kSamples = 400;
        const auto store =
            SampleStore::make(types::typeOps<double>(), spec(StoreSpec::Data, StoreSpec::LockFree), nullptr);
        std::atomic<std::uint64_t> written{0};
        std::atomic<unsigned> fresh[kSamples + 1] = {};
        const auto readAll = [&] {
            for (double sample = 0; sample < kSamples;)
                if (store->read(&sample, true) == NewData) ++fresh[static_cast<std::size_t>(sample)];
        };
        std::thread writer([&] {
            for (double sample = 1; sample <= kSamples; ++sample, ++written)
                ASSERT_EQ(store->write(&sample), WriteSuccess);
        });
        std::thread first(readAll);
        while (written < kSamples / 4 + round % 64) std::this_thread::yield();
        std::thread second(readAll);
        for (std::thread* const thread : {&writer, &first, &second}) thread->join();
        for (const std::atomic<unsigned>& times : fresh) ASSERT_LE(times, 1u) << "sample " << &times - fresh;
        double sample = 0;
        const FlowStatus status = store->read(&sample, true);
        EXPECT_EQ(status == NewData, fresh[kSamples] == 0u);
    }
}
