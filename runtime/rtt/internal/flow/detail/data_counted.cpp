// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// DATA, LOCK_FREE, for samples of any type.
//
// A pool of slots, each with one state word: a count of readers and two flags. Held: a writer owns the slot, or it is
// the current one. Unread: its sample was not read yet. A slot is free when it is neither counted nor held.
//
//   writer                                             reader
//   state: free -> Held|Unread   CAS, acquire   (W1)   c = current_, acquire              (R1)
//   assign the sample                                  state[c] += 1, acq_rel             (R2)
//   old = exchange current_      acq_rel        (W2)   current_ still c? acquire; else    (R3)
//   state[old] &= ~Held          release        (W3)     state[c] -= 1 and start again
//                                                      copy; state[c]: -1, clear Unread   (R4)
//
// If R2 comes before W3 in the order of changes of state[c], the count keeps W1 away until R4. If it comes after, it
// synchronises with W3, so R3 sees W2 or a later publication; if that is c again, c is complete and held anew, and the
// first case applies to it. So a slot that R3 accepts stays complete until R4. If R3 fails the reader copies nothing;
// its short visit in the count of a foreign slot only makes W1 pass over it. R3 fails only because a writer published,
// so the system makes progress.
// Each thread has at most one slot, and one is current: with max_threads + 2 slots, max_threads + 1 threads never fail.
// A sample is new for the one reader that clears Unread: by its R4, or before it copies if it wants only new samples.
#include <rtt/internal/flow/detail/stores.hpp>
#include <rtt/internal/flow/sample_box.hpp>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <thread>

namespace RTT::internal::detail {

namespace {

typedef std::uint32_t State;
constexpr State kHeld = State(1) << 31;
constexpr State kUnread = State(1) << 30;
constexpr std::size_t kNone = ~std::size_t(0);

struct Header {
    std::atomic<State> state{0};
    std::atomic<std::uint32_t> turn{0};  // of its samples; only the owner changes it
    std::atomic<std::size_t> extent{0};  // the largest so far; only the owner changes it
};

class CountedData final : public SampleStore {
public:
    CountedData(const types::TypeOps& ops, std::size_t threads, const void* first)
        : SampleStore(ops), samples_(ops, threads + 2, first, sizeof(Header), 64) {
        for (std::size_t i = 0; i < samples_.count(); ++i) new (samples_.header(i)) Header;
    }

    WriteStatus write(const void* sample) override {
        const std::size_t extent = extentOf(sample);
        const std::size_t i = claim(extent);
        if (i == kNone) return WriteFailure;
        bool assigned = false;
        AtEnd giveBack([&] {
            if (!assigned) unhold(i);
        });
        // Release: a thread that finds this turn also finds that another slot was current before.
        header(i).turn.store(header(i).turn.load(std::memory_order_relaxed) + 1, std::memory_order_release);
        assign(i, sample, extent);
        assigned = true;
        publish(i);
        keepSized(sample, extent);
        return WriteSuccess;
    }

    FlowStatus read(void* sample, bool copyOld) override {
        for (;;) {
            const std::size_t c = current_.load(std::memory_order_acquire);  // R1
            if (c == kNone) return NoData;
            std::atomic<State>& s = state(c);
            s.fetch_add(1, std::memory_order_acq_rel);          // R2
            if (current_.load(std::memory_order_acquire) == c)  // R3
                return copyAndLeave(s, samples_.sample(c), sample, copyOld);
            s.fetch_sub(1, std::memory_order_release);
        }
    }

    void clear() override { publish(kNone); }
    std::size_t size() const override {
        const std::size_t c = current_.load(std::memory_order_acquire);
        return c != kNone && (state(c).load(std::memory_order_acquire) & kUnread) ? 1 : 0;
    }
    std::uint64_t newest() const override {
        for (;;) {
            const std::size_t c = current_.load(std::memory_order_acquire);
            if (c == kNone) return 0;
            // A turn of a sample that is not published yet is found only while another slot is current.
            const std::uint64_t turn = header(c).turn.load(std::memory_order_acquire);
            if (c == current_.load(std::memory_order_acquire)) return turn << 32U | (c + 1);
        }
    }

private:
    Header& header(std::size_t i) const { return *static_cast<Header*>(samples_.header(i)); }
    std::atomic<State>& state(std::size_t i) const { return header(i).state; }
    void assign(std::size_t i, const void* sample, std::size_t extent) {
        assignSample(ops_, samples_.sample(i), sample);
        if (extent > header(i).extent.load(std::memory_order_relaxed))
            header(i).extent.store(extent, std::memory_order_relaxed);
    }

    /** Tries slots that are large enough first, then any. */
    std::size_t claim(std::size_t extent) {
        const std::size_t n = samples_.count();
        std::size_t i = freed_.load(std::memory_order_relaxed);
        for (std::size_t tries = 0; tries < 3 * n; ++tries) {
            if ((tries >= n || header(i).extent.load(std::memory_order_relaxed) >= extent) && claimSlot(i)) return i;
            i = i + 1 < n ? i + 1 : 0;
        }
        return kNone;
    }
    bool claimSlot(std::size_t i) {
        State now = state(i).load(std::memory_order_relaxed);
        return (now & ~kUnread) == 0 &&
               state(i).compare_exchange_strong(now, kHeld | kUnread, std::memory_order_acquire,
                                                std::memory_order_relaxed);  // W1
    }
    void publish(std::size_t i) {
        const std::size_t old = current_.exchange(i, std::memory_order_acq_rel);  // W2
        if (old == kNone) return;
        unhold(old);
        freed_.store(old, std::memory_order_relaxed);
    }
    void unhold(std::size_t i) { state(i).fetch_and(~kHeld, std::memory_order_release); }  // W3

    FlowStatus copyAndLeave(std::atomic<State>& s, const void* from, void* to, bool copyOld) {
        if (!copyOld) return copyNewAndLeave(s, from, to);
        bool copied = false;
        AtEnd leave([&] {
            if (!copied) s.fetch_sub(1, std::memory_order_release);
        });
        assignSample(ops_, to, from);
        copied = true;
        State now = s.load(std::memory_order_relaxed);
        while (!s.compare_exchange_weak(now, (now - 1) & ~kUnread, std::memory_order_acq_rel)) {
        }  // R4
        return now & kUnread ? NewData : OldData;
    }

    /** A reader that must not copy an old sample has to know that it is the first one before it copies. */
    FlowStatus copyNewAndLeave(std::atomic<State>& s, const void* from, void* to) {
        const bool unread = (s.load(std::memory_order_relaxed) & kUnread) &&
                            (s.fetch_and(~kUnread, std::memory_order_acq_rel) & kUnread);
        bool copied = !unread;
        AtEnd leave([&] {
            if (!copied) s.fetch_or(kUnread, std::memory_order_relaxed);
            s.fetch_sub(1, std::memory_order_release);
        });
        if (unread) assignSample(ops_, to, from);
        copied = true;
        return unread ? NewData : OldData;
    }

    void resizeElements(const void* sample, bool all) override {
        const std::size_t end = all ? samples_.count() : std::min(kAtOnce, samples_.count());
        for (std::size_t i = 0; i < end; ++i) {
            for (int tries = 0; tries < 1000; ++tries) {  // a slot in use for longer is sized by its next write
                if (claimSlot(i)) {
                    AtEnd giveBack([&] { unhold(i); });
                    assign(i, sample, extentOf(sample));
                    break;
                }
                if (!all || current_.load(std::memory_order_relaxed) == i) break;
                std::this_thread::yield();
            }
        }
    }

    SampleArray samples_;
    // Writers try it first: large samples stay in the caches if the same few slots are reused.
    std::atomic<std::size_t> freed_{0};
    alignas(64) std::atomic<std::size_t> current_{kNone};
};

}  // namespace

StorePtr makeCountedData(const types::TypeOps& ops, const StoreSpec& spec, const void* first) {
    return StorePtr(new CountedData(ops, spec.maxThreads, first));
}

}  // namespace RTT::internal::detail
