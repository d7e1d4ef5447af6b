// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// BUFFER and CIRCULAR_BUFFER, LOCK_FREE, for small trivially copyable samples: one atomic read-modify-write per write
// of the home thread, two per write of another thread, one per read. Any number of writers and readers.
//
// As in buffer_lock_free.cpp, samples lie in slots, and a ring of words {turn, slot} holds their order. But here
// samples are atomic words too, so a reader may copy one that it does not own and then learn whether it is valid:
//
//   writer, with a spare slot s                        reader
//   words of s            release each       (W1)      h    = head_               acquire     (R1)
//   t - head_ < room, else full              (W2)      word = ring[h] has turn h? acquire     (R2)
//   ring[t]: {t-P, old} -> {t, s}            (W3)      words of its slot          acquire each (R3)
//                         CAS, acq_rel                 head_: h -> h+1            CAS, acq_rel (R4)
//   tail_ = t+1           release            (W4)
//   `old` is the spare slot now
//
// P, the length of the ring, is more than `room`, so W2 implies head_ > t-P+1: the sample in `old` was taken, and the
// one after it, too. So if R4 succeeds, head_ was h during R3, no writer had the slot as a spare, and the copy is
// whole. Conversely, if R3 sees a word of the slot's next owner, its acquire pairs with that W1, and the W3 by which
// that owner got the slot, and its W2, happened before: R4 finds another head_ and fails. R2 pairs with W3 and so sees
// W1.
// Each R4 succeeds for one reader, so each sample is new for exactly one.
// A reader that stops anywhere owns nothing. A writer that stops owns one slot that no other thread needs: the home
// thread (home_thread.hpp) its own spare, others one of the shared ones, see claim().
//
// The sample before head_ is still there: an empty buffer gives it as OldData. Copied in the same way, it is valid if
// head_ is still h afterwards.
//
// tail_ is a hint, at most the true tail: W3 decides. A writer that stopped before W4 may set it back; the next one
// then starts at head_ and passes the words that have later turns. By W4, tail_ comes with what its writer knew of
// head_, so a new tail_ and an old head_ do not look like a full buffer. Writers may use an old value of head_ as long
// as it leaves room: it only grows.
// A full circular buffer takes the new sample first and then drops the oldest. So readers never find it empty, and
// whenever the buffer is empty, the sample before head_ was read, not dropped.
// A turn is a position modulo 2^40: only a thread that sleeps for exactly that many is fooled.
#include <rtt/internal/flow/detail/home_thread.hpp>
#include <rtt/internal/flow/detail/sample_times.hpp>
#include <rtt/internal/flow/detail/sample_words.hpp>
#include <rtt/internal/flow/detail/stores.hpp>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <new>

namespace RTT::internal::detail {

namespace {

typedef SampleWord Word;
constexpr unsigned kSlotBits = 24;
constexpr Word kSlotMask = (Word(1) << kSlotBits) - 1;
constexpr Word kClaimed = Word(1) << 63;
constexpr std::size_t kMaxCapacity = kSlotMask / 4;

Word pack(Word turn, Word slot) { return turn << kSlotBits | slot; }
Word slotOf(Word word) { return word & kSlotMask; }
/** True if the turn in `word` is position `p`. */
bool hasTurn(Word word, Word p) { return word >> kSlotBits == (p << kSlotBits) >> kSlotBits; }

std::size_t powerOfTwo(std::size_t atLeast) {
    std::size_t n = 2;
    while (n < atLeast) n *= 2;
    return n;
}

struct Slot {
    std::size_t spare = 0;  // the index in spares_, for a sample held by readHeld()
    AtomicWord words[1];    // in fact as many as a sample needs
};

class WordBuffer final : public SampleStore {
public:
    WordBuffer(const types::TypeOps& ops, const StoreSpec& spec)
        : SampleStore(ops),
          capacity_(spec.size),
          circular_(spec.kind == StoreSpec::CircularBuffer),
          oldData_(spec.oldData),
          words_(wordsFor(ops.size)),
          room_(circular_ ? capacity_ + 1 : capacity_),
          ringMask_(powerOfTwo(capacity_ + 2) - 1),
          spareCount_(spec.maxThreads + 1),
          stride_(sizeof(Slot) + (words_ - 1) * sizeof(AtomicWord)),
          ring_(new std::atomic<Word>[ringMask_ + 1]),
          spares_(new std::atomic<Word>[spareCount_]),
          block_(new unsigned char[stride_ * slotCount()]) {
        Word slot = 0;
        for (Word i = 0; i <= ringMask_; ++i)
            ring_[i].store(pack(i - (ringMask_ + 1), make(slot++)), std::memory_order_relaxed);
        for (std::size_t i = 0; i < spareCount_; ++i) spares_[i].store(make(slot++), std::memory_order_relaxed);
        homeSlot_ = make(slot);
    }

    WriteStatus write(const void* sample) override {
        if (home_.here()) return write(homeSlot_, homeHead_, sample);
        const std::size_t spare = claim();
        if (spare == spareCount_) return drop();
        Word slot = claimed(spare), head = 0;
        const WriteStatus status = write(slot, head, sample);
        giveBack(spare, slot);
        home_.wrote();
        return status;
    }

    FlowStatus read(void* sample, bool copyOld) override { return read(sample, copyOld, nullptr); }
    FlowStatus read(void* sample, bool copyOld, std::int64_t* time) {
        WordsCopy<> copy;
        for (;;) {
            Word h = head_.load(std::memory_order_acquire);                          // R1
            const Word word = ring_[h & ringMask_].load(std::memory_order_acquire);  // R2
            if (hasTurn(word, h)) {
                loadWords(copy, at(slotOf(word)).words, words_);  // R3
                const std::int64_t written = time ? times_.of(slotOf(word)) : 0;
                if (!takeOut(h)) continue;  // R4
                copyOut(sample, copy, ops_.size);
                if (time) *time = written;
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
        const Word end = head_.load(std::memory_order_acquire) + size();  // samples written meanwhile may stay
        Word h = head_.load(std::memory_order_acquire);
        while (h < end && hasTurn(ring_[h & ringMask_].load(std::memory_order_acquire), h)) {
            takeOut(h);
            h = head_.load(std::memory_order_acquire);
        }
        Word before = cleared_.load(std::memory_order_relaxed);
        while (before < h && !cleared_.compare_exchange_weak(before, h, std::memory_order_acq_rel)) {
        }
    }

    // The held sample is a copy in a spare slot, so other threads need not check whether the one before head_ is held.
    const void* readHeld() override {
        const std::size_t spare = claim();
        if (spare == spareCount_) return nullptr;
        const Word slot = claimed(spare);
        WordsCopy<> copy;
        for (;;) {
            Word h = head_.load(std::memory_order_acquire);
            const Word word = ring_[h & ringMask_].load(std::memory_order_acquire);
            if (hasTurn(word, h)) {
                loadWords(copy, at(slotOf(word)).words, words_);
                if (!takeOut(h)) continue;
                storeWords(at(slot).words, &copy, ops_.size);
                at(slot).spare = spare;
                return at(slot).words;
            }
            if (!hasTurn(word, h - (ringMask_ + 1))) continue;
            giveBack(spare, slot);
            return nullptr;
        }
    }
    void release(const void* held) override {
        const auto offset = static_cast<const unsigned char*>(held) - block_.get();
        const Word slot = static_cast<std::size_t>(offset) / stride_;
        giveBack(at(slot).spare, slot);
    }

    std::size_t capacity() const override { return capacity_; }
    std::size_t size() const override {
        const Word head = head_.load(std::memory_order_acquire);
        Word tail = std::max(head, tail_.load(std::memory_order_acquire));
        while (hasTurn(ring_[tail & ringMask_].load(std::memory_order_acquire), tail)) ++tail;
        return std::min<std::size_t>(tail - head, capacity_);
    }
    std::size_t dropped() const override { return dropped_.load(std::memory_order_relaxed); }

    bool keepTimes() override {
        times_.begin(slotCount());
        return true;
    }
    FlowStatus readTimed(void* sample, std::int64_t& time) override { return read(sample, false, &time); }

private:
    Slot& at(Word slot) const { return *reinterpret_cast<Slot*>(block_.get() + slot * stride_); }
    Word make(Word slot) {
        Slot* made = new (&at(slot)) Slot;
        for (std::size_t w = 1; w < words_; ++w) new (made->words + w) AtomicWord;
        return slot;
    }
    WriteStatus drop() {
        dropped_.fetch_add(1, std::memory_order_relaxed);
        return WriteFailure;
    }

    /** Claims a spare slot until the caller gives that one, or another, back. spareCount_ only if more threads are
        inside at once than the buffer was made for. Acquire and release: the slot comes with what its last owner knew
        of head_. */
    std::size_t claim() {
        for (int rounds = 0; rounds < 2; ++rounds) {
            for (std::size_t i = 0; i < spareCount_; ++i) {
                Word slot = spares_[i].load(std::memory_order_relaxed);
                if (slot & kClaimed) continue;
                if (spares_[i].compare_exchange_strong(slot, slot | kClaimed, std::memory_order_acquire,
                                                       std::memory_order_relaxed))
                    return i;
            }
        }
        return spareCount_;
    }
    Word claimed(std::size_t spare) const { return slotOf(spares_[spare].load(std::memory_order_relaxed)); }
    void giveBack(std::size_t spare, Word slot) { spares_[spare].store(slot, std::memory_order_release); }

    /** Writes to the spare `slot`, and exchanges it for another one. `head` is an earlier value of head_. */
    WriteStatus write(Word& slot, Word& head, const void* sample) {
        if (capacity_ == 0 || (!circular_ && full(head))) return drop();
        storeWords(at(slot).words, sample, ops_.size);  // W1
        times_.written(slot);
        return enter(slot, head) ? WriteSuccess : drop();
    }
    /** True only if it was full at one moment: head_ was the same before and after reading tail_, which is never too
        high. If it is too low, enter() notices. */
    bool full(Word& head) const {
        for (;;) {
            if (tail_.load(std::memory_order_acquire) < head + capacity_) return false;
            const Word now = head_.load(std::memory_order_acquire);
            if (now == head) return true;
            head = now;
        }
    }
    /** False if the buffer is full and not circular. */
    bool enter(Word& slot, Word& head) {
        for (;;) {
            const Word t = std::max(head, tail_.load(std::memory_order_acquire));
            std::atomic<Word>& cell = ring_[t & ringMask_];
            Word word = cell.load(std::memory_order_acquire);
            if (hasTurn(word, t)) {
                tail_.store(t + 1, std::memory_order_release);
                continue;
            }
            if (t - head >= room_) {  // W2
                const Word now = head_.load(std::memory_order_acquire);
                if (now == head && !circular_) return false;
                if (now == head) giveUpOldest(head, t);
                head = now;
                continue;
            }
            if (!hasTurn(word, t - (ringMask_ + 1))) {  // filled and emptied since head_ was `head`
                head = head_.load(std::memory_order_acquire);
                continue;
            }
            if (!cell.compare_exchange_strong(word, pack(t, slot), std::memory_order_acq_rel)) continue;  // W3
            slot = slotOf(word);
            tail_.store(t + 1, std::memory_order_release);  // W4
            if (circular_ && t + 1 - head > capacity_) {
                head = head_.load(std::memory_order_acquire);
                giveUpOldest(head, t + 1);
            }
            return true;
        }
    }
    /** Drops the oldest sample if the buffer held too many, those from `h` to before `t`. */
    void giveUpOldest(Word h, Word t) {
        if (t > h + capacity_ && takeOut(h)) drop();
    }

    /** R4; false if head_ is no longer `h`. */
    bool takeOut(Word h) {
        return head_.compare_exchange_strong(h, h + 1, std::memory_order_acq_rel, std::memory_order_relaxed);
    }

    void resizeElements(const void*, bool) override {}  // plain samples all have one size
    std::size_t slotCount() const { return ringMask_ + 1 + spareCount_ + 1; }

    const std::size_t capacity_;
    const bool circular_, oldData_;
    const std::size_t words_;
    const Word room_, ringMask_;
    const std::size_t spareCount_, stride_;
    const std::unique_ptr<std::atomic<Word>[]> ring_, spares_;
    const std::unique_ptr<unsigned char[]> block_;
    SampleTimes times_;
    // Writers change these, readers those below: each group has a cache line of its own.
    alignas(64) std::atomic<Word> tail_{0};
    HomeThread home_;
    Word homeSlot_, homeHead_ = 0;  // of the home thread
    std::atomic<std::size_t> dropped_{0};
    alignas(64) std::atomic<Word> head_{0};
    std::atomic<Word> cleared_{0};  // samples before this position are dropped
};

}  // namespace

bool fitsWordBuffer(const types::TypeOps& ops, const StoreSpec& spec) {
    // The alignment matters because readHeld() shows the words as a sample.
    return fitsWords(ops) && ops.align <= alignof(AtomicWord) && spec.size <= kMaxCapacity;
}

StorePtr makeWordBuffer(const types::TypeOps& ops, const StoreSpec& spec) {
    return StorePtr(new WordBuffer(ops, spec));
}

}  // namespace RTT::internal::detail
