// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSCOMM_DETAIL_DUE_PUBLISHER_HPP
#define RTT_ROSCOMM_DETAIL_DUE_PUBLISHER_HPP

#include <atomic>

namespace rtt_roscomm::detail {

/** What the publish activity visits when it has something to send. Counted: a list holds what is in it. */
class DuePublisher {
public:
    DuePublisher() = default;
    virtual ~DuePublisher() = default;
    DuePublisher(const DuePublisher&) = delete;
    DuePublisher& operator=(const DuePublisher&) = delete;

    /** Sends what waits; called by the thread of the publish activity. */
    virtual void publishDue() = 0;

    void ref() { references_.fetch_add(1, std::memory_order_relaxed); }
    void deref() {
        if (references_.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
    }

private:
    friend class DueList;
    std::atomic<int> references_{0};
    std::atomic<bool> isDue_{false};
    DuePublisher* next_ = nullptr;  // of the list that it is in
};

inline void intrusive_ptr_add_ref(DuePublisher* one) { one->ref(); }
inline void intrusive_ptr_release(DuePublisher* one) { one->deref(); }

/** Any number of threads add publishers, one takes them. Neither ever waits. */
class DueList {
public:
    DueList() = default;
    /** Each is in the list at most once, and held by it. False if it was there already. */
    bool add(DuePublisher& one) {
        // Release and acquire: what was written before is seen by the thread that takes the flag down.
        if (one.isDue_.exchange(true, std::memory_order_acq_rel)) return false;
        one.ref();
        DuePublisher* first = first_.load(std::memory_order_relaxed);
        do {
            one.next_ = first;
        } while (!first_.compare_exchange_weak(first, &one, std::memory_order_release, std::memory_order_relaxed));
        return true;
    }
    /** Calls visit(one) for each, in the order in which they were added. Each can be added again by then. */
    template <class Visit>
    void takeAll(Visit visit) {
        DuePublisher* last = first_.exchange(nullptr, std::memory_order_acquire);
        DuePublisher* next = nullptr;
        while (last) {
            DuePublisher* const before = last->next_;
            last->next_ = next;
            next = last;
            last = before;
        }
        while (next) {
            DuePublisher* const one = next;
            next = one->next_;  // before another thread can add it
            one->isDue_.exchange(false, std::memory_order_acq_rel);
            visit(*one);
            one->deref();
        }
    }

private:
    std::atomic<DuePublisher*> first_{nullptr};
};

}  // namespace rtt_roscomm::detail

#endif
