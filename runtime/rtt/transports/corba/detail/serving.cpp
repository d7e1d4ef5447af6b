// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/serving.hpp>

#include <rtt/os/SignalsBlocked.hpp>
#include <rtt/os/futex.hpp>

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include <pthread.h>

namespace RTT::corba::detail {

namespace {

/** Threads that wait for work, as many as there has been at once. */
class CallThreads {
public:
    void execute(std::function<void()> work) {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (work_.size() >= idle_) begin();
        work_.push_back(std::move(work));
        arrived_.notify_one();
    }

private:
    void begin() {
        const os::SignalsBlocked blocked;
        std::thread([this] { loop(); }).detach();
        ++idle_;
    }
    void loop() {
        pthread_setname_np(pthread_self(), "CorbaCall");
        std::unique_lock<std::mutex> lock(mutex_);
        for (;;) {
            arrived_.wait(lock, [this] { return !work_.empty(); });
            std::function<void()> next = std::move(work_.front());
            work_.pop_front();
            --idle_;
            lock.unlock();
            next();
            next = nullptr;
            lock.lock();
            ++idle_;
        }
    }

    std::mutex mutex_;
    std::condition_variable arrived_;
    std::deque<std::function<void()>> work_;
    std::size_t idle_ = 0;
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
