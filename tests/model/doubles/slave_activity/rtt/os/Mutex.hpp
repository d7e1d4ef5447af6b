// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's header: mutexes of the checker's.
#ifndef OROFORGE_MODEL_MUTEX_HPP
#define OROFORGE_MODEL_MUTEX_HPP

namespace RTT {
namespace os {

typedef std::mutex Mutex;

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

}  // namespace os
}  // namespace RTT
#endif
