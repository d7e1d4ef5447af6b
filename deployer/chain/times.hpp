// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CHAIN_TIMES_HPP
#define OROFORGE_CHAIN_TIMES_HPP

#include <ocl/ChainStatistics.hpp>

#include <array>
#include <atomic>
#include <cstdint>

namespace OCL::chain {

/** A number that one thread changes and others read. */
template <class T>
class Shown {
public:
    T operator()() const noexcept { return value_.load(std::memory_order_relaxed); }
    void set(T value) noexcept { value_.store(value, std::memory_order_relaxed); }
    /** Only for the thread that changes it. */
    void add(T more) noexcept { set((*this)() + more); }

private:
    std::atomic<T> value_{};
};

/** Statistics of durations in ns. One thread adds, in constant time on average; any thread reads. */
class Times {
public:
    /** Real-time safe. Negative ones count as 0. */
    void add(std::int64_t ns) noexcept;
    /** For the thread that adds, or while none does. */
    void reset() noexcept;
    /** Real-time safe. */
    void read(ChainTimes& result) const noexcept;
    std::uint64_t count() const noexcept { return count_(); }
    double mean() const noexcept { return count_() ? sum_() / static_cast<double>(count_()) : 0; }

private:
    // A bucket per 32nd part of an octave, from 32 ns to over a minute.
    static constexpr unsigned kBits = 5, kSteps = 1u << kBits, kOctaves = 33;
    static constexpr unsigned kBuckets = kSteps * kOctaves;
    static unsigned bucketOf(std::uint64_t ns) noexcept;
    static double upperEnd(unsigned bucket) noexcept;
    void follow(unsigned bucket) noexcept;

    Shown<std::uint64_t> count_;
    Shown<std::int64_t> last_, min_, max_;
    Shown<double> sum_, squares_;
    Shown<unsigned> quantile_;  // the bucket of the 99.9 %
    std::uint64_t above_ = 0;   // times in buckets above that
    std::array<std::uint32_t, kBuckets> buckets_{};
};

}  // namespace OCL::chain

#endif
