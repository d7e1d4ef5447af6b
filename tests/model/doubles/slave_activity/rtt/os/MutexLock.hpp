// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's header: a recursive mutex of the checker's.
#ifndef OROFORGE_MODEL_MUTEX_LOCK_HPP
#define OROFORGE_MODEL_MUTEX_LOCK_HPP

namespace RTT {
namespace os {

class MutexRecursive {
public:
    void lock() {
        if (owner_.load(std::memory_order_relaxed) != model::self() + 1) {
            mutex_.lock();
            owner_.store(model::self() + 1, std::memory_order_relaxed);
        }
        ++depth_;
    }
    void unlock() {
        if (--depth_ != 0) return;
        owner_.store(0, std::memory_order_relaxed);
        mutex_.unlock();
    }

private:
    std::mutex mutex_;
    std::atomic<unsigned> owner_{0};
    int depth_ = 0;
};

class MutexLock {
public:
    explicit MutexLock(MutexRecursive& mutex) : mutex_(mutex) { mutex_.lock(); }
    ~MutexLock() { mutex_.unlock(); }

private:
    MutexRecursive& mutex_;
};

}  // namespace os
}  // namespace RTT
#endif
