// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// BUFFER and CIRCULAR_BUFFER, LOCK_FREE: any number of writers and readers, any type of sample.
//
// Samples lie in a pool of slots; a ring of words {turn, slot} says which ones are in the buffer and in what order.
// A writer first fills a slot of its own and then enters it into the ring; a reader first takes a slot out and then
// copies it. So a thread that stops while it copies holds a slot, never a place in the ring, and hinders no other.
//
//   enter at tail t                                    take out at head h
//   t - head_ < room, else full                        word of ring[h] has turn h, else empty or h is stale
//   word of ring[t]: turn t-P -> {t, slot}  CAS  (W1)  head_: h -> h+1                 CAS  (R1)
//   tail_: t -> t+1  CAS, any thread may help          the slot is the reader's
//
// A full circular buffer has room for one more: it takes the new sample first and then drops the oldest, so readers
// never find it empty.
//
// P, the length of the ring, is at least `room`, so the word with turn t-P was taken out (head_ > t-P) before
// W1 replaces it, and a word cannot change before R1 took it. W1 is a release, loading the word an acquire: the reader
// sees the sample. A turn is a position modulo 2^40: only a thread that sleeps for exactly that many is fooled.
//
// The slot read last stays out of the pool as `last_`, for readers of an empty buffer (OldData). Slots are counted:
// owner 1, `last_` 1 (taken over from the reader), and each reader of an old sample 1. That reader counts first, then
// looks whether `last_` (which has a serial number) is unchanged; only then was the slot not free when it counted.
#include <rtt/internal/flow/detail/buffer_part.hpp>
#include <rtt/internal/flow/detail/sample_times.hpp>
#include <rtt/internal/flow/detail/stores.hpp>
#include <rtt/internal/flow/sample_box.hpp>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <thread>

namespace RTT::internal::detail {

namespace {

typedef std::uint64_t Word;
constexpr unsigned kSlotBits = 24;
constexpr Word kSlotMask = (Word(1) << kSlotBits) - 1;
constexpr Word kNoSlot = kSlotMask;
constexpr std::size_t kMaxCapacity = kSlotMask / 2;

Word pack(Word turn, Word slot) { return turn << kSlotBits | slot; }
Word slotOf(Word word) { return word & kSlotMask; }
/** True if the turn in `word` is position `p`. */
bool hasTurn(Word word, Word p) { return word >> kSlotBits == (p << kSlotBits) >> kSlotBits; }

std::size_t powerOfTwo(std::size_t atLeast) {
    std::size_t n = 2;
    while (n < atLeast) n *= 2;
    return n;
}

class LockFreeBuffer final : public BufferPart {
    typedef std::atomic<std::uint32_t> Count;
    struct Header {
        Count count{0};
        std::atomic<std::size_t> extent{0};  // the largest so far; only the owner changes it
        std::atomic<Stamp> stamp{0};
    };

public:
    LockFreeBuffer(const types::TypeOps& ops, const StoreSpec& spec, const void* first)
        : BufferPart(ops),
          capacity_(spec.size),
          circular_(spec.kind == StoreSpec::CircularBuffer),
          oldData_(spec.oldData),
          room_(circular_ ? capacity_ + 1 : capacity_),
          ringMask_(powerOfTwo(room_) - 1),
          ring_(new std::atomic<Word>[ringMask_ + 1]),
          // those in the buffer, the last read, one that each thread uses and one that it drops
          samples_(ops, room_ + 2 + (circular_ ? 2 : 1) * spec.maxThreads, first, sizeof(Header)) {
        for (std::size_t i = 0; i < samples_.count(); ++i) new (samples_.header(i)) Header;
        for (Word i = 0; i <= ringMask_; ++i)
            ring_[i].store(pack(i - (ringMask_ + 1), kNoSlot), std::memory_order_relaxed);
    }

    WriteStatus write(const void* sample) override { return tryWrite(sample, 0) ? WriteSuccess : drop(); }

    bool tryWrite(const void* sample, Stamp stamp) override {
        if (capacity_ == 0 || (!circular_ && full())) return false;
        const std::size_t extent = extentOf(sample);
        const Word slot = claim(extent);
        if (slot == kNoSlot) return false;
        bool entered = false;
        AtEnd giveBack([&] {
            if (!entered) release(slot);
        });
        assign(slot, sample, extent);
        header(slot).stamp.store(stamp, std::memory_order_release);
        times_.written(slot);
        while (!(entered = enter(slot))) {
            if (!circular_) return false;
            giveUpOldest();
        }
        if (circular_) giveUpOldest();
        keepSized(sample, extent);
        return true;
    }

    bool oldest(Oldest& found) const override {
        for (;;) {
            const Word h = head_.load(std::memory_order_acquire);
            const Word word = wordAt(h);
            found.position = h;
            if (hasTurn(word, h)) {
                found.stamp = header(slotOf(word)).stamp.load(std::memory_order_acquire);
                // Otherwise the slot may be in use again, and the stamp another sample's.
                if (head_.load(std::memory_order_acquire) == h) return true;
            } else if (hasTurn(word, h - (ringMask_ + 1))) {
                return false;
            }
        }
    }
    bool takeOldest(const Oldest& known, void* sample) override {
        const Word word = wordAt(known.position);
        if (!hasTurn(word, known.position) || !moveHead(known.position)) return false;
        AtEnd keep([&] { makeLast(slotOf(word)); });
        assignSample(ops_, sample, samples_.sample(slotOf(word)));
        return true;
    }
    std::uint64_t takenOut() const override { return head_.load(std::memory_order_acquire); }
    /** head_ was the same before and after reading tail_. */
    bool full() const override {
        Word head = head_.load(std::memory_order_acquire);
        for (;;) {
            const Word tail = tail_.load(std::memory_order_acquire);
            if (tail < head + capacity_) return false;
            const Word again = head_.load(std::memory_order_acquire);
            if (again == head) return true;
            head = again;
        }
    }
    std::uint64_t entered() const override { return tail_.load(std::memory_order_relaxed); }
    int readOld(void* sample, bool copyOld) override { return readLast(sample, copyOld); }

    FlowStatus read(void* sample, bool copyOld) override { return read(sample, copyOld, nullptr); }
    FlowStatus read(void* sample, bool copyOld, std::int64_t* time) {
        for (;;) {
            const Word slot = takeOut();
            if (slot == kNoSlot) {
                if (!oldData_) return NoData;
                const int old = readLast(sample, copyOld);
                if (old >= 0) return static_cast<FlowStatus>(old);
                continue;
            }
            AtEnd keep([&] { makeLast(slot); });
            if (time) *time = times_.of(slot);
            assignSample(ops_, sample, samples_.sample(slot));
            return NewData;
        }
    }

    void clear() override {
        const Word end = tail_.load(std::memory_order_acquire);  // samples written meanwhile may stay
        while (head_.load(std::memory_order_acquire) < end) {
            const Word slot = takeOut();
            if (slot == kNoSlot) break;
            release(slot);
        }
        setLast(kNoSlot);
    }

    const void* readHeld() override {
        const Word slot = takeOut();
        if (slot == kNoSlot) return nullptr;
        count(slot).fetch_add(1, std::memory_order_relaxed);
        makeLast(slot);
        return samples_.sample(slot);
    }
    void release(const void* held) override {
        const std::size_t stride =
            static_cast<unsigned char*>(samples_.sample(1)) - static_cast<unsigned char*>(samples_.sample(0));
        release(static_cast<Word>(
            (static_cast<const unsigned char*>(held) - static_cast<const unsigned char*>(samples_.sample(0))) /
            stride));
    }

    std::size_t capacity() const override { return capacity_; }
    std::size_t size() const override {
        const Word head = head_.load(std::memory_order_acquire);
        const Word tail = tail_.load(std::memory_order_acquire);
        return tail > head ? std::min<std::size_t>(tail - head, capacity_) : 0;
    }
    std::size_t dropped() const override { return dropped_.load(std::memory_order_relaxed); }

    bool keepTimes() override {
        times_.begin(samples_.count());
        return true;
    }
    FlowStatus readTimed(void* sample, std::int64_t& time) override { return read(sample, false, &time); }

private:
    Header& header(Word slot) const { return *static_cast<Header*>(samples_.header(slot)); }
    Count& count(Word slot) const { return header(slot).count; }
    void assign(Word slot, const void* sample, std::size_t extent) {
        assignSample(ops_, samples_.sample(slot), sample);
        if (extent > header(slot).extent.load(std::memory_order_relaxed))
            header(slot).extent.store(extent, std::memory_order_relaxed);
    }
    WriteStatus drop() {
        dropped_.fetch_add(1, std::memory_order_relaxed);
        return WriteFailure;
    }
    /** Tries slots that are large enough first, then any. */
    Word claim(std::size_t extent) {
        const Word freed = freed_.load(std::memory_order_relaxed);
        if (isLarge(freed, extent) && claimSlot(freed)) return freed;
        const std::size_t n = samples_.count();
        std::size_t i = hint_.load(std::memory_order_relaxed);
        for (std::size_t tries = 0; tries < 3 * n; ++tries) {
            i = i + 1 < n ? i + 1 : 0;
            if ((tries < n && !isLarge(i, extent)) || !claimSlot(i)) continue;
            hint_.store(i, std::memory_order_relaxed);
            return i;
        }
        return kNoSlot;
    }
    bool isLarge(Word slot, std::size_t extent) const {
        return header(slot).extent.load(std::memory_order_relaxed) >= extent;
    }
    bool claimSlot(Word slot) {
        std::uint32_t free = 0;
        return count(slot).load(std::memory_order_relaxed) == 0 &&
               count(slot).compare_exchange_strong(free, 1, std::memory_order_acquire, std::memory_order_relaxed);
    }
    void release(Word slot) {
        count(slot).fetch_sub(1, std::memory_order_release);
        freed_.store(slot, std::memory_order_relaxed);
    }

    /** False if the buffer is full. */
    bool enter(Word slot) {
        for (;;) {
            Word t = tail_.load(std::memory_order_acquire);
            const Word h = head_.load(std::memory_order_acquire);
            if (t >= h && t - h >= room_) {
                if (tail_.load(std::memory_order_relaxed) == t) return false;
                continue;
            }
            std::atomic<Word>& cell = ring_[t & ringMask_];
            Word word = cell.load(std::memory_order_acquire);
            if (hasTurn(word, t - (ringMask_ + 1))) {
                if (!cell.compare_exchange_strong(word, pack(t, slot), std::memory_order_acq_rel)) continue;  // W1
                tail_.compare_exchange_strong(t, t + 1, std::memory_order_acq_rel);
                return true;
            }
            if (hasTurn(word, t)) tail_.compare_exchange_strong(t, t + 1, std::memory_order_acq_rel);
        }
    }
    /** kNoSlot if the buffer is empty. */
    Word takeOut() {
        for (;;) {
            const Word h = head_.load(std::memory_order_acquire);
            const Word word = wordAt(h);
            if (hasTurn(word, h)) {
                if (moveHead(h)) return slotOf(word);
            } else if (hasTurn(word, h - (ringMask_ + 1))) {
                return kNoSlot;
            }
        }
    }
    Word wordAt(Word p) const { return ring_[p & ringMask_].load(std::memory_order_acquire); }
    bool moveHead(Word h) { return head_.compare_exchange_strong(h, h + 1, std::memory_order_acq_rel); }  // R1
    /** Drops the oldest sample if the buffer holds too many. */
    void giveUpOldest() {
        const Word h = head_.load(std::memory_order_acquire);
        if (tail_.load(std::memory_order_acquire) <= h + capacity_) return;
        const Word word = wordAt(h);
        if (!hasTurn(word, h) || !moveHead(h)) return;
        release(slotOf(word));
        drop();
    }

    void makeLast(Word slot) {
        if (oldData_)
            setLast(slot);
        else
            release(slot);
    }
    void setLast(Word slot) {
        Word old = last_.load(std::memory_order_relaxed);
        while (!last_.compare_exchange_weak(old, pack((old >> kSlotBits) + 1, slot), std::memory_order_acq_rel)) {
        }
        if (slotOf(old) != kNoSlot) release(slotOf(old));
    }
    /** The status, or -1 if another reader interfered. */
    int readLast(void* sample, bool copyOld) {
        const Word last = last_.load(std::memory_order_acquire);
        const Word slot = slotOf(last);
        if (slot == kNoSlot) return NoData;
        if (!copyOld) return OldData;
        count(slot).fetch_add(1, std::memory_order_acq_rel);
        AtEnd leave([&] { release(slot); });
        if (last_.load(std::memory_order_acquire) != last) return -1;
        assignSample(ops_, sample, samples_.sample(slot));
        return OldData;
    }

    void resizeElements(const void* sample, bool all) override {
        std::size_t left = all ? samples_.count() : kAtOnce;
        for (std::size_t i = 0; i < samples_.count() && left > 0; ++i) {
            std::uint32_t free = 0;  // one in use is sized already, or by its next write
            if (!count(i).compare_exchange_strong(free, 1, std::memory_order_acquire)) continue;
            AtEnd giveBack([&] { release(Word(i)); });
            assign(i, sample, extentOf(sample));
            --left;
        }
    }

    const std::size_t capacity_;
    const bool circular_, oldData_;
    const Word room_, ringMask_;
    const std::unique_ptr<std::atomic<Word>[]> ring_;
    SampleArray samples_;
    SampleTimes times_;
    alignas(64) std::atomic<Word> tail_{0};
    std::atomic<std::size_t> hint_{0};
    std::atomic<std::size_t> dropped_{0};
    alignas(64) std::atomic<Word> head_{0};
    std::atomic<Word> last_{kNoSlot};
    // Writers try it first, so that large samples stay in the caches; next to head_, which they read anyway.
    std::atomic<Word> freed_{0};
};

}  // namespace

StorePtr makeLockFreeBuffer(const types::TypeOps& ops, const StoreSpec& spec, const void* first) {
    if (spec.size > kMaxCapacity) return nullptr;
    return StorePtr(new LockFreeBuffer(ops, spec, first));
}

std::unique_ptr<BufferPart> makeBufferPart(const types::TypeOps& ops, const StoreSpec& spec, const void* first) {
    return std::unique_ptr<BufferPart>(new LockFreeBuffer(ops, spec, first));
}

}  // namespace RTT::internal::detail
