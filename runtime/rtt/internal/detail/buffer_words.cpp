// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// BUFFER and CIRCULAR_BUFFER, LOCK_FREE, for small trivially copyable samples: two atomic read-modify-writes per write,
// one per read. Any number of writers and readers.
//
// As in buffer_lock_free.cpp samples lie in slots, and a ring of words {turn, slot} tells their order. But here samples
// are atomic words too, so a reader may copy one that it does not own and learn afterwards whether it was valid:
//
//   writer                                             reader
//   used[s]: 0 -> 1       CAS, acquire       (W1)      h    = head_               acquire     (R1)
//   words of s            release each       (W2)      word = ring[h] has turn h? acquire     (R2)
//   ring[t]: turn t-P -> {t, s}  CAS, acq_rel (W3)     words of its slot          acquire each (R3)
//   tail_ = t+1           relaxed            (W4)      head_: h -> h+1            CAS, acq_rel (R4)
//                                                      used of the slot at h-1: 0  release     (R5)
//
// The slot at h stays in use until somebody has moved head_ from h+1 to h+2 and done R5. So if R4 succeeds, head_ was h
// during R3 and the copy is whole. Conversely, if R3 sees a word of the slot's next owner, its acquire pairs with W2, and
// W1, R5 and the two R4s before it happened before: R4 finds another head_ and fails. R2 pairs with W3 and so sees W2.
// Each R4 succeeds for one reader, so each sample is new for exactly one, and that one alone does R5 for the slot before.
// A reader that stops anywhere owns no place in the ring and at most one slot, a writer likewise; see claim().
//
// The sample before head_ is still there: it is what an empty buffer gives as OldData. Copied in the same way, it is
// valid if head_ is still h afterwards. Its ring word stays, because P is at least the capacity plus two.
//
// tail_ is a hint, at most the true tail: W3 decides. It may be set back by a writer that stopped before W4; the next
// one starts at head_ then and passes the words that have later turns.
// A full circular buffer takes the new sample first and gives up the oldest then, so readers never find it empty and the
// sample before head_ was read, not given up, whenever the buffer is empty.
// A turn is a position modulo 2^40; to be fooled a thread must sleep for exactly that many.
#include <rtt/internal/detail/sample_words.hpp>
#include <rtt/internal/detail/stores.hpp>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <new>

namespace RTT {
namespace internal {
namespace detail {

namespace {

typedef SampleWord Word;
constexpr unsigned kSlotBits = 24;
constexpr Word kNoSlot = (Word(1) << kSlotBits) - 1;
constexpr std::size_t kMaxCapacity = kNoSlot / 2;

Word pack(Word turn, Word slot) { return turn << kSlotBits | slot; }
Word slotOf(Word word) { return word & kNoSlot; }
/** True if the turn in `word` is position `p`. */
bool hasTurn(Word word, Word p) { return word >> kSlotBits == (p << kSlotBits) >> kSlotBits; }

std::size_t powerOfTwo(std::size_t atLeast) {
    std::size_t n = 2;
    while (n < atLeast) n *= 2;
    return n;
}

struct Slot {
    std::atomic<std::uint32_t> used{0};
    AtomicWord words[1];  // really as many as the sample needs
};

class WordBuffer final : public SampleStore {
public:
    WordBuffer(const types::TypeOps& ops, const StoreSpec& spec)
        : SampleStore(ops),
          capacity_(spec.size),
          circular_(spec.kind == StoreSpec::CircularBuffer),
          oldData_(spec.oldData),
          words_(wordsFor(ops.size)),
          ringMask_(powerOfTwo(capacity_ + 2) - 1),
          // in the buffer, the one more of a circular one, the one before head_, and one in the hands of each thread
          slots_(capacity_ + 2 + spec.maxThreads),
          stride_(sizeof(Slot) + (words_ - 1) * sizeof(AtomicWord)),
          ring_(new std::atomic<Word>[ringMask_ + 1]),
          block_(new unsigned char[stride_ * slots_]) {
        for (Word i = 0; i < slots_; ++i) {
            Slot* slot = new (block_.get() + i * stride_) Slot;
            for (std::size_t w = 1; w < words_; ++w) new (slot->words + w) AtomicWord;
        }
        for (Word i = 0; i <= ringMask_; ++i)
            ring_[i].store(pack(i - (ringMask_ + 1), kNoSlot), std::memory_order_relaxed);
    }

    WriteStatus write(const void* sample) override {
        if (capacity_ == 0 || (!circular_ && full())) return drop();
        const Word slot = claim();
        if (slot == kNoSlot) return drop();
        storeWords(at(slot).words, sample, ops_.size);  // W2
        if (enter(slot)) return WriteSuccess;
        at(slot).used.store(0, std::memory_order_release);
        return drop();
    }

    FlowStatus read(void* sample, bool copyOld) override {
        WordsCopy copy;
        for (;;) {
            Word h = head_.load(std::memory_order_acquire);                          // R1
            const Word word = ring_[h & ringMask_].load(std::memory_order_acquire);  // R2
            if (hasTurn(word, h)) {
                loadWords(copy, at(slotOf(word)).words, words_);  // R3
                if (!takeOut(h)) continue;                        // R4, R5
                copyOut(sample, copy, ops_.size);
                return NewData;
            }
            if (!hasTurn(word, h - (ringMask_ + 1))) continue;  // head_ has moved on since R1
            if (!oldData_ || h <= cleared_.load(std::memory_order_acquire)) return NoData;
            if (!copyOld) return OldData;
            const Word last = ring_[(h - 1) & ringMask_].load(std::memory_order_acquire);
            if (!hasTurn(last, h - 1)) continue;
            loadWords(copy, at(slotOf(last)).words, words_);
            if (head_.load(std::memory_order_relaxed) != h) continue;
            copyOut(sample, copy, ops_.size);
            return OldData;
        }
    }

    void clear() override {
        const Word end = head_.load(std::memory_order_acquire) + size();  // what others write meanwhile may stay
        Word h = head_.load(std::memory_order_acquire);
        while (h < end && hasTurn(ring_[h & ringMask_].load(std::memory_order_acquire), h)) {
            takeOut(h);
            h = head_.load(std::memory_order_acquire);
        }
        Word before = cleared_.load(std::memory_order_relaxed);
        while (before < h && !cleared_.compare_exchange_weak(before, h, std::memory_order_acq_rel)) {
        }
    }

    // The sample held is a copy in a slot of its own, so that others need not ask whether the one before head_ is held.
    const void* readHeld() override {
        const Word slot = claim();
        if (slot == kNoSlot) return nullptr;
        WordsCopy copy;
        for (;;) {
            Word h = head_.load(std::memory_order_acquire);
            const Word word = ring_[h & ringMask_].load(std::memory_order_acquire);
            if (hasTurn(word, h)) {
                loadWords(copy, at(slotOf(word)).words, words_);
                if (!takeOut(h)) continue;
                storeWords(at(slot).words, &copy, ops_.size);
                return at(slot).words;
            }
            if (!hasTurn(word, h - (ringMask_ + 1))) continue;
            at(slot).used.store(0, std::memory_order_release);
            return nullptr;
        }
    }
    void release(const void* held) override {
        const auto offset = static_cast<const unsigned char*>(held) - block_.get();
        at(static_cast<std::size_t>(offset) / stride_).used.store(0, std::memory_order_release);
    }

    std::size_t capacity() const override { return capacity_; }
    std::size_t size() const override {
        const Word head = head_.load(std::memory_order_acquire);
        Word tail = std::max(head, tail_.load(std::memory_order_relaxed));
        while (hasTurn(ring_[tail & ringMask_].load(std::memory_order_acquire), tail)) ++tail;
        return std::min<std::size_t>(tail - head, capacity_);
    }
    std::size_t dropped() const override { return dropped_.load(std::memory_order_relaxed); }

private:
    Slot& at(Word slot) const { return *reinterpret_cast<Slot*>(block_.get() + slot * stride_); }
    WriteStatus drop() {
        dropped_.fetch_add(1, std::memory_order_relaxed);
        return WriteFailure;
    }

    /** kNoSlot only with more threads in here at once than the buffer was made for. */
    Word claim() {
        std::size_t i = hint_.load(std::memory_order_relaxed);
        for (std::size_t tries = 2 * slots_; tries > 0; --tries) {
            i = i + 1 < slots_ ? i + 1 : 0;
            std::atomic<std::uint32_t>& used = at(i).used;
            std::uint32_t free = 0;
            if (used.load(std::memory_order_relaxed) == 0 &&
                used.compare_exchange_strong(free, 1, std::memory_order_acquire, std::memory_order_relaxed)) {  // W1
                hint_.store(i, std::memory_order_relaxed);
                return i;
            }
        }
        return kNoSlot;
    }

    /** Only if it really was full at one moment: head_ was the same before and after looking at tail_, which is never
        too high. It may be too low; enter() finds out then. */
    bool full() const {
        Word head = head_.load(std::memory_order_acquire);
        for (;;) {
            if (tail_.load(std::memory_order_relaxed) < head + capacity_) return false;
            const Word again = head_.load(std::memory_order_acquire);
            if (again == head) return true;
            head = again;
        }
    }

    /** False if the buffer is full and not circular. */
    bool enter(Word slot) {
        const Word room = circular_ ? capacity_ + 1 : capacity_;
        for (;;) {
            Word h = head_.load(std::memory_order_acquire);
            const Word t = std::max(h, tail_.load(std::memory_order_relaxed));
            std::atomic<Word>& cell = ring_[t & ringMask_];
            Word word = cell.load(std::memory_order_acquire);
            if (hasTurn(word, t)) {
                tail_.store(t + 1, std::memory_order_relaxed);
                continue;
            }
            if (t - h >= room) {
                if (circular_)
                    giveUpOldest(h, t);
                else if (head_.load(std::memory_order_acquire) == h)
                    return false;
                continue;
            }
            // A cell of a later turn: others filled and emptied it since we looked at head_.
            if (!hasTurn(word, t - (ringMask_ + 1))) continue;
            if (!cell.compare_exchange_strong(word, pack(t, slot), std::memory_order_acq_rel)) continue;  // W3
            tail_.store(t + 1, std::memory_order_relaxed);                                                // W4
            if (circular_) giveUpOldest(h, t + 1);
            return true;
        }
    }
    /** Of a buffer that held the samples from `h` to before `t`, if these are more than it may hold. */
    void giveUpOldest(Word h, Word t) {
        if (t - h > capacity_ && takeOut(h)) drop();
    }

    /** R4 and R5; false if head_ is not `h` any more. */
    bool takeOut(Word h) {
        const Word before = slotOf(ring_[(h - 1) & ringMask_].load(std::memory_order_relaxed));
        if (!head_.compare_exchange_strong(h, h + 1, std::memory_order_acq_rel, std::memory_order_relaxed))
            return false;
        // Nobody has replaced that word before head_ moved, and it was written before the one at h.
        if (before != kNoSlot) at(before).used.store(0, std::memory_order_release);
        return true;
    }

    void resizeElements(const void*, bool) override {}  // plain samples all have one size

    const std::size_t capacity_;
    const bool circular_, oldData_;
    const std::size_t words_;
    const Word ringMask_;
    const std::size_t slots_, stride_;
    const std::unique_ptr<std::atomic<Word>[]> ring_;
    const std::unique_ptr<unsigned char[]> block_;
    // Writers change these, readers those below: each on a cache line of its own.
    alignas(64) std::atomic<Word> tail_{0};
    std::atomic<std::size_t> hint_{0};  // where the last writer was; only spreads the writers
    std::atomic<std::size_t> dropped_{0};
    alignas(64) std::atomic<Word> head_{0};
    std::atomic<Word> cleared_{0};  // what was before this position is forgotten
};

}  // namespace

bool fitsWordBuffer(const types::TypeOps& ops, const StoreSpec& spec) {
    // The alignment, because readHeld() shows the words as a sample.
    return fitsWords(ops) && ops.align <= alignof(AtomicWord) && spec.size <= kMaxCapacity;
}

StorePtr makeWordBuffer(const types::TypeOps& ops, const StoreSpec& spec) {
    return StorePtr(new WordBuffer(ops, spec));
}

}  // namespace detail
}  // namespace internal
}  // namespace RTT
