// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/serving.hpp>

#include <rtt/os/SignalsBlocked.hpp>
#include <rtt/os/futex.hpp>

#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include <pthread.h>

namespace RTT::corba::detail {

namespace {

/**
 * Threads that wait for work, as many as there has been at once. Work goes to the one that waits for the shortest time,
 * by a word of its own: it takes no lock that the giver still has, and what it used is still in the caches.
 */
class CallThreads {
public:
    void execute(std::function<void()> work) {
        if (Waiting* const one = take()) {
            one->work = std::move(work);
            one->given.store(1, std::memory_order_release);
            os::detail::futexWakeOne(one->given);  // the thread, and so its word, exists until the process ends
            return;
        }
        const os::SignalsBlocked blocked;
        std::thread([this, first = std::move(work)]() mutable { loop(std::move(first)); }).detach();
    }

private:
    struct Waiting {
        std::atomic<std::uint32_t> given{0};
        std::function<void()> work;
        Waiting* next = nullptr;
    };

    /** Null if none waits. */
    Waiting* take() {
        const std::lock_guard<std::mutex> lock(mutex_);
        Waiting* const one = waiting_;
        if (one) waiting_ = one->next;
        return one;
    }
    void put(Waiting& one) {
        const std::lock_guard<std::mutex> lock(mutex_);
        one.next = waiting_;
        waiting_ = &one;
    }
    [[noreturn]] void loop(std::function<void()> work) {
        pthread_setname_np(pthread_self(), "CorbaCall");
        Waiting self;
        for (;;) {
            work();
            work = nullptr;
            put(self);
            while (self.given.load(std::memory_order_acquire) == 0)
                (void)os::detail::futexWait(self.given, 0, os::detail::kForever);
            self.given.store(0, std::memory_order_relaxed);
            work = std::move(self.work);
        }
    }

    std::mutex mutex_;
    Waiting* waiting_ = nullptr;
};

CallThreads& callThreads() {
    static auto* const threads = new CallThreads();  // never destroyed: its threads use it until the process ends
    return *threads;
}

}  // namespace

void executeAside(std::function<void()> work) { callThreads().execute(std::move(work)); }

void executeElsewhere(const std::function<void()>& work) {
    std::exception_ptr thrown;
    std::atomic<std::uint32_t> done{0};
    executeAside([&] {
        try {
            work();
        } catch (...) {
            thrown = std::current_exception();
        }
        // The waiting thread leaves as soon as it sees the value: only the address is used after that.
        done.store(1, std::memory_order_release);
        os::detail::futexWakeAll(done);
    });
    while (done.load(std::memory_order_acquire) == 0) internal::EngineGate::sleepOn(done, 0);
    if (thrown) std::rethrow_exception(thrown);
}

}  // namespace RTT::corba::detail
