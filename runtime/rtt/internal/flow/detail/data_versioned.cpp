// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// DATA, LOCK_FREE, for small trivially copyable samples: no atomic read-modify-write per write of the home thread, one
// per write of another thread, one per new sample read.
//
// Slots hold the sample in atomic words next to a version. `current_` names a slot and the version it had when it was
// published. A reader copies the words of the current slot and takes them only if the slot had that version before and
// after; otherwise the slot was taken for a newer sample and the reader starts again with the newer current one. So
// readers own nothing, a stopped reader hinders no thread, and a reader starts again only if writers made progress.
//
//   writer                                        reader
//   owner: 0 -> 1        CAS, acquire      (W1)   seen    = read_               (R0)
//   is it the current slot? then give back        current = current_, acquire   (R1)
//   version = v+1        relaxed           (W2)   version == v+1?  acquire      (R2)
//   words                release each      (W3)   words    acquire each         (R3)
//   current_ = slot,v+1  release           (W4)   version == v+1?               (R4)
//   owner = 0            release           (W5)   read_: seen -> current  CAS   (R5)
//
// R1 reads from W4, so R3 sees at least the words of that version. If R3 sees a word of a later version, its acquire
// pairs with W3, W2 of that version happened before, and R4 finds the version changed. R3's acquire also keeps R4 after
// it. A writer that claims a slot by W1, after its last owner's W5, sees that owner's W4 or a later publication. If the
// slot is still current, the writer gives it back untouched; if not, only its new owner can make it current again. Thus
// the current slot is never written.
// The home thread (home_thread.hpp) skips W1 and W5: it uses its own slots in turn, so the next one is not the one that
// it published last, and only that one of them can be current.
// New or old: R5 succeeds only if no reader took any sample since R0, so each publication is new for exactly one
// reader. If it fails, another reader was first; this one starts again and cannot return an older sample.
// The sole reader (sole_reader.hpp) uses a plain store in R5: no other thread takes samples meanwhile.
#include <rtt/internal/flow/detail/home_thread.hpp>
#include <rtt/internal/flow/detail/sample_words.hpp>
#include <rtt/internal/flow/detail/sole_reader.hpp>
#include <rtt/internal/flow/detail/stores.hpp>

#include <atomic>
#include <cstdint>
#include <new>

namespace RTT::internal::detail {

namespace {

typedef SampleWord Word;
constexpr unsigned kSlotBits = 16;
constexpr std::size_t kHomeSlots = 3;  // come first
constexpr Word kNone = ~Word(0);       // no slot ever has this version

struct Slot {
    std::atomic<std::uint32_t> owner{0};
    std::atomic<Word> version{0};  // written by the owner only
    AtomicWord words[1];           // in fact as many as a sample needs
};

/** For samples of kSize bytes, or of any size if that is 0. */
template <std::size_t kSize>
class VersionedData final : public SampleStore {
public:
    VersionedData(const types::TypeOps& ops, std::size_t threads)
        : SampleStore(ops),
          slots_(kHomeSlots + threads + 2),
          stride_(strideFor(sizeof(Slot) + (words() - 1) * sizeof(Word))),
          block_(static_cast<unsigned char*>(::operator new(stride_* slots_, std::align_val_t(64)))) {
        for (std::size_t i = 0; i < slots_; ++i) {
            Slot* s = new (block_ + i * stride_) Slot;
            for (std::size_t w = 1; w < words(); ++w) new (s->words + w) AtomicWord;
        }
    }
    ~VersionedData() override { ::operator delete(block_, std::align_val_t(64)); }

    WriteStatus write(const void* sample) override {
        if (home_.here()) {
            publish(homeNext_, sample);
            homeNext_ = homeNext_ + 1 < kHomeSlots ? homeNext_ + 1 : 0;
            return WriteSuccess;
        }
        std::size_t i = hint_.load(std::memory_order_relaxed);
        for (std::size_t tries = 2 * slots_; tries > 0; --tries) {
            i = i + 1 < slots_ ? i + 1 : kHomeSlots;
            Slot& slot = at(i);
            if (indexOf(current_.load(std::memory_order_relaxed)) == i) continue;
            std::uint32_t free = 0;
            if (!slot.owner.compare_exchange_strong(free, 1, std::memory_order_acquire, std::memory_order_relaxed))
                continue;  // W1
            if (indexOf(current_.load(std::memory_order_acquire)) == i) {
                slot.owner.store(0, std::memory_order_release);
                continue;
            }
            hint_.store(i, std::memory_order_relaxed);
            publish(i, sample);
            slot.owner.store(0, std::memory_order_release);  // W5
            home_.wrote();
            return WriteSuccess;
        }
        return WriteFailure;
    }

    FlowStatus read(void* sample, bool copyOld) override {
        const SoleReader::Reading reading(reader_);
        for (;;) {
            Word seen = read_.load(std::memory_order_acquire);              // R0
            const Word current = current_.load(std::memory_order_acquire);  // R1
            if (current == kNone) return NoData;
            const bool isNew = seen != current && !reading.late();
            if (!isNew && !copyOld) return OldData;
            const Slot& slot = at(indexOf(current));
            const Word version = current >> kSlotBits;
            if (slot.version.load(std::memory_order_acquire) != version) continue;  // R2
            WordsCopy<kSize == 0 ? kMaxSampleWords : wordsFor(kSize)> copy;
            loadWords(copy, slot.words, words());                                   // R3
            if (slot.version.load(std::memory_order_relaxed) != version) continue;  // R4
            if (isNew && !take(seen, current, reading.alone())) continue;           // R5
            copyOut(sample, copy, bytes());
            return isNew ? NewData : OldData;
        }
    }

    void clear() override { current_.store(kNone, std::memory_order_release); }
    std::size_t size() const override {
        const Word current = current_.load(std::memory_order_acquire);
        return current != kNone && current != read_.load(std::memory_order_acquire) ? 1 : 0;
    }
    std::uint64_t newest() const override {
        const Word current = current_.load(std::memory_order_acquire);
        return current == kNone ? 0 : current;  // versions begin at 1
    }

private:
    std::size_t bytes() const { return kSize == 0 ? ops_.size : kSize; }
    std::size_t words() const { return wordsFor(bytes()); }
    /** Two small slots share a cache line. */
    static std::size_t strideFor(std::size_t size) { return size <= 32 ? 32 : (size + 63) / 64 * 64; }
    void publish(std::size_t i, const void* sample) {
        Slot& slot = at(i);
        const Word version = slot.version.load(std::memory_order_relaxed) + 1;
        slot.version.store(version, std::memory_order_relaxed);               // W2
        storeWords(slot.words, sample, bytes());                              // W3
        current_.store(version << kSlotBits | i, std::memory_order_release);  // W4
    }
    bool take(Word seen, Word current, bool alone) {
        if (!alone) return read_.compare_exchange_strong(seen, current, std::memory_order_acq_rel);
        read_.store(current, std::memory_order_release);
        return true;
    }
    static std::size_t indexOf(Word current) { return current & ((Word(1) << kSlotBits) - 1); }
    Slot& at(std::size_t i) const { return *reinterpret_cast<Slot*>(block_ + i * stride_); }
    void resizeElements(const void*, bool) override {}  // plain samples all have one size

    const std::size_t slots_, stride_;
    unsigned char* const block_;
    // Writers change the first ones, readers the last ones: each group has a cache line of its own.
    alignas(64) std::atomic<Word> current_{kNone};
    HomeThread home_;
    std::size_t homeNext_ = 0;                   // of the home thread
    std::atomic<std::size_t> hint_{kHomeSlots};  // the last slot of another writer; only spreads them
    alignas(64) std::atomic<Word> read_{kNone};
    SoleReader reader_;
};

}  // namespace

bool fitsVersionedData(const types::TypeOps& ops) { return fitsWords(ops); }

StorePtr makeVersionedData(const types::TypeOps& ops, const StoreSpec& spec) {
    if (ops.size == sizeof(double)) return StorePtr(new VersionedData<sizeof(double)>(ops, spec.maxThreads));
    return StorePtr(new VersionedData<0>(ops, spec.maxThreads));
}

}  // namespace RTT::internal::detail
