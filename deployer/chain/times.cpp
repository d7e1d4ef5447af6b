// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "times.hpp"

#include <algorithm>
#include <cmath>

namespace OCL::chain {

unsigned Times::bucketOf(std::uint64_t ns) noexcept {
    if (ns < kSteps) return static_cast<unsigned>(ns);
    const unsigned octave = 63u - static_cast<unsigned>(__builtin_clzll(ns)) - kBits;  // the bits below the highest one
    const unsigned bucket = (octave + 1) * kSteps + static_cast<unsigned>((ns >> octave) - kSteps);
    return std::min(bucket, kBuckets - 1);
}

double Times::upperEnd(unsigned bucket) noexcept {
    if (bucket < kSteps) return bucket;
    const unsigned octave = bucket / kSteps - 1;
    return std::ldexp(bucket % kSteps + kSteps + 1, static_cast<int>(octave));
}

void Times::add(std::int64_t ns) noexcept {
    ns = std::max<std::int64_t>(ns, 0);
    const std::uint64_t before = count_();
    if (before == 0 || ns < min_()) min_.set(ns);
    if (before == 0 || ns > max_()) max_.set(ns);
    last_.set(ns);
    const auto value = static_cast<double>(ns);
    sum_.add(value);
    squares_.add(value * value);
    const unsigned bucket = bucketOf(static_cast<std::uint64_t>(ns));
    ++buckets_[bucket];
    if (before == 0) quantile_.set(bucket);
    count_.set(before + 1);
    follow(bucket);
}

// Moves the quantile to the lowest bucket above which there are at most 0.1 % of the times.
void Times::follow(unsigned bucket) noexcept {
    const std::uint64_t allowed = count_() / 1000;
    unsigned at = quantile_();
    if (bucket > at) ++above_;
    while (above_ > allowed) above_ -= buckets_[++at];
    while (at > 0 && above_ + buckets_[at] <= allowed) above_ += buckets_[at--];
    if (at != quantile_()) quantile_.set(at);
}

void Times::reset() noexcept {
    count_.set(0);
    last_.set(0);
    min_.set(0);
    max_.set(0);
    sum_.set(0);
    squares_.set(0);
    quantile_.set(0);
    above_ = 0;
    buckets_.fill(0);
}

void Times::read(ChainTimes& result) const noexcept {
    constexpr double kSecond = 1e9;
    const std::uint64_t count = count_();
    result.count = static_cast<unsigned>(count);
    result.last = static_cast<double>(last_()) / kSecond;
    result.min = static_cast<double>(min_()) / kSecond;
    result.max = static_cast<double>(max_()) / kSecond;
    const double mean = count ? sum_() / static_cast<double>(count) : 0;
    const double square = count ? squares_() / static_cast<double>(count) : 0;
    result.mean = mean / kSecond;
    result.deviation = std::sqrt(std::max(0.0, square - mean * mean)) / kSecond;
    result.p999 = count ? std::min(upperEnd(quantile_()) / kSecond, result.max) : 0;
}

}  // namespace OCL::chain
