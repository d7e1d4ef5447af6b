// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// BUFFER, LOCK_FREE, for many writers: several lock-free buffers, the parts, each with its share of the places.
//
// At first all writers write to one part, and when it is full to the next one: the state counts these changes. From the
// moment at which writers on several processors take turns, each writes to the part of its processor, so that hardly a
// line of memory passes from one processor to another, and if that is full, to any other. So all places are used,
// and a sample is refused only if all parts were full at one moment: only readers make room, and they move the position
// of a part.
//
// Each sample has a stamp, and the reader takes the one with the smallest: the state, or later the time at which its
// write began, which is larger than any such state. Within a part, samples have the order in which they entered. Let
// sample a enter before the write of b begins, as always if one thread writes both. What is in front of a in its part
// entered before a, so its stamp is not larger than b's, nor is a's; and two samples with one state as their stamp are
// in one part. So whatever is at the head of a's part, the reader takes a before b, if it sees it. A reader that has
// found b sees all that entered before; so it looks at the other parts again before it takes b.
#include <rtt/internal/flow/buffer_parts.hpp>
#include <rtt/internal/flow/detail/buffer_part.hpp>
#include <rtt/internal/flow/detail/stores.hpp>
#include <rtt/internal/flow/detail/writer_place.hpp>

#include <algorithm>
#include <array>
#include <atomic>

namespace RTT::internal::detail {

namespace {

constexpr std::size_t kMostParts = 8, kSmallestPart = 8;
constexpr std::size_t kMostSamples = 1 << 20;  // in all parts; a larger buffer is not divided

/** Finds out whether writers on several processors take turns: a thread that is moved to another one now and then is no
    reason for parts. */
class Turns {
public:
    /** True if they do. `written` counts samples. */
    bool notice(unsigned processor, std::uint64_t written) {
        if (processor == processor_.load(std::memory_order_relaxed)) return false;
        processor_.store(processor, std::memory_order_relaxed);
        const bool quick = written - changedAt_.exchange(written, std::memory_order_relaxed) < kQuick;
        if (!quick) changes_.store(0, std::memory_order_relaxed);
        return quick && changes_.fetch_add(1, std::memory_order_relaxed) >= kMany;
    }

private:
    static constexpr std::uint64_t kQuick = 32;
    static constexpr unsigned kMany = 8;
    std::atomic<unsigned> processor_{0}, changes_{0};
    std::atomic<std::uint64_t> changedAt_{0};
};

class PartedBuffer final : public SampleStore {
    typedef BufferPart::Oldest Oldest;
    typedef BufferPart::Stamp State;
    typedef std::array<std::uint64_t, kMostParts> Positions;

public:
    PartedBuffer(const types::TypeOps& ops, const StoreSpec& spec, const void* first, std::size_t parts)
        : SampleStore(ops), capacity_(spec.size), oldData_(spec.oldData), count_(parts) {
        StoreSpec part = spec;
        for (std::size_t i = 0; i < count_; ++i) {
            part.size = capacity_ / count_ + (i < capacity_ % count_ ? 1 : 0);
            parts_[i] = makeBufferPart(ops, part, first);
        }
    }

    WriteStatus write(const void* sample) override {
        const unsigned processor = processorNow();
        State state = state_.load(std::memory_order_relaxed);
        if (isOfProcessors(state)) return writeAt(processor, sample);
        if (turns_.notice(processor, parts_[state % count_]->entered())) {
            state_.fetch_or(kOfProcessors, std::memory_order_relaxed);
            return writeAt(processor, sample);
        }
        return parts_[state % count_]->tryWrite(sample, state) ? WriteSuccess : writeToNext(state, processor, sample);
    }

    FlowStatus read(void* sample, bool copyOld) override {
        for (;;) {
            Oldest found;
            const std::size_t part = findOldest(found);
            if (part != kNone) {
                if (!parts_[part]->takeOldest(found, sample)) continue;
                if (oldData_) last_.store(part, std::memory_order_release);
                return NewData;
            }
            if (!oldData_) return NoData;
            const int old = parts_[last_.load(std::memory_order_acquire)]->readOld(sample, copyOld);
            if (old >= 0) return static_cast<FlowStatus>(old);
        }
    }

    void clear() override {
        for (std::size_t i = 0; i < count_; ++i) parts_[i]->clear();
    }

    std::size_t capacity() const override { return capacity_; }
    std::size_t size() const override {
        std::size_t sum = 0;
        for (std::size_t i = 0; i < count_; ++i) sum += parts_[i]->size();
        return sum;
    }
    std::size_t dropped() const override { return dropped_.load(std::memory_order_relaxed); }

private:
    static constexpr std::size_t kNone = kMostParts;
    static constexpr State kOfProcessors = State(1) << 63;
    static constexpr int kTries = 100;  // more fail only if more threads write than it was made for

    static bool isOfProcessors(State state) { return (state & kOfProcessors) != 0; }

    /** Writes to the part of the processor, or to any other. */
    WriteStatus writeAt(unsigned processor, const void* sample) {
        const BufferPart::Stamp stamp = kOfProcessors | stampNow();
        const std::size_t own = processor % count_;
        if (parts_[own]->tryWrite(sample, stamp)) return WriteSuccess;
        for (;;) {
            const Positions before = takenOut();
            for (std::size_t i = 0; i < count_; ++i)
                if (parts_[(own + i) % count_]->tryWrite(sample, stamp)) return WriteSuccess;
            if (takenOut() == before) return drop();
        }
    }

    /** The part of `state` had no room. */
    WriteStatus writeToNext(State state, unsigned processor, const void* sample) {
        for (int tries = 0; tries < kTries; ++tries) {
            const Positions before = takenOut();
            if (areFull() && takenOut() == before) break;
            if (state_.compare_exchange_strong(state, state + 1, std::memory_order_relaxed)) ++state;
            if (isOfProcessors(state)) return writeAt(processor, sample);
            if (parts_[state % count_]->tryWrite(sample, state)) return WriteSuccess;
        }
        return drop();
    }
    bool areFull() const {
        for (std::size_t i = 0; i < count_; ++i)
            if (!parts_[i]->full()) return false;
        return true;
    }

    WriteStatus drop() {
        dropped_.fetch_add(1, std::memory_order_relaxed);
        return WriteFailure;
    }

    Positions takenOut() const {
        Positions positions{};
        for (std::size_t i = 0; i < count_; ++i) positions[i] = parts_[i]->takenOut();
        return positions;
    }

    /** The part that has the oldest sample; kNone if all were empty. */
    std::size_t findOldest(Oldest& found) const {
        std::size_t part = kNone;
        for (;;) {
            Positions seen{};
            bool better = false;
            for (std::size_t i = 0; i < count_; ++i) {
                Oldest candidate;
                if (i == part) continue;
                const bool any = parts_[i]->oldest(candidate);
                seen[i] = candidate.position;
                if (!any || (part != kNone && candidate.stamp >= found.stamp)) continue;
                found = candidate;
                part = i;
                better = true;
            }
            // If another reader has taken something, there may have been a sample all the time.
            if (!better && (part != kNone || takenOut() == seen)) return part;
        }
    }

    void resizeElements(const void* sample, bool all) override {
        for (std::size_t i = 0; i < count_; ++i) parts_[i]->resizeElements(sample, all);
    }

    const std::size_t capacity_;
    const bool oldData_;
    const std::size_t count_;
    std::array<std::unique_ptr<BufferPart>, kMostParts> parts_;
    std::atomic<State> state_{0};
    alignas(64) Turns turns_;
    alignas(64) std::atomic<std::size_t> last_{0};  // the part that was read last
    alignas(64) std::atomic<std::size_t> dropped_{0};
};

}  // namespace

StorePtr makePartedBuffer(const types::TypeOps& ops, const StoreSpec& spec, const void* first) {
    const std::size_t parts = bufferParts(spec.size);
    return parts < 2 ? makeLockFreeBuffer(ops, spec, first) : StorePtr(new PartedBuffer(ops, spec, first, parts));
}

}  // namespace RTT::internal::detail

std::size_t RTT::internal::bufferParts(std::size_t size) {
    using namespace detail;
    if (size > kMostSamples) return 1;
    return std::max<std::size_t>(1, std::min({kMostParts, std::size_t{processorCount()}, size / kSmallestPart}));
}

std::size_t RTT::internal::bufferElements(std::size_t size, std::size_t threads) {
    return size + bufferParts(size) * (2 + threads);
}
