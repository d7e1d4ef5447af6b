// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DETAIL_SAMPLE_TIMES_HPP
#define ORO_INTERNAL_DETAIL_SAMPLE_TIMES_HPP

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <memory>

namespace RTT {
namespace internal {
namespace detail {

/** When the samples in the slots of a store were written, if somebody wants that. Costs a load otherwise. The time of a
    slot belongs to the owner of the slot, as its sample does; it is an atomic for readers that copy without owning it,
    see sample_words.hpp. */
class SampleTimes {
public:
    SampleTimes() = default;
    ~SampleTimes() { delete[] times_.load(std::memory_order_relaxed); }
    SampleTimes(const SampleTimes&) = delete;
    SampleTimes& operator=(const SampleTimes&) = delete;

    /** Other threads may write meanwhile. */
    void begin(std::size_t slots) {
        std::unique_ptr<Time[]> made(new Time[slots]);
        for (std::size_t i = 0; i != slots; ++i) made[i].store(0, std::memory_order_relaxed);
        Time* none = nullptr;
        if (times_.compare_exchange_strong(none, made.get(), std::memory_order_acq_rel)) (void)made.release();
    }
    void written(std::size_t slot) noexcept {
        Time* const times = times_.load(std::memory_order_acquire);
        if (__builtin_expect(times != nullptr, 0)) times[slot].store(now(), std::memory_order_release);
    }
    /** ns since 1970; 0 if it is not known. */
    std::int64_t of(std::size_t slot) const noexcept {
        const Time* const times = times_.load(std::memory_order_acquire);
        return times ? times[slot].load(std::memory_order_acquire) : 0;
    }

private:
    typedef std::atomic<std::int64_t> Time;
    static std::int64_t now() noexcept {
        timespec time{};
        clock_gettime(CLOCK_REALTIME, &time);
        return std::int64_t(time.tv_sec) * 1000000000 + time.tv_nsec;
    }

    std::atomic<Time*> times_{nullptr};
};

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
