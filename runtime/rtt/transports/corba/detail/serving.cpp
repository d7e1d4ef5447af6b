// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/serving.hpp>

#include <rtt/os/SignalsBlocked.hpp>
#include <rtt/os/futex.hpp>

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>

#include <pthread.h>

namespace RTT::corba::detail {

namespace {

struct Job {
    const std::function<void()>& work;
    std::exception_ptr thrown = nullptr;
    std::atomic<std::uint32_t> state{0};  // 1 when it is done
};

/** Threads that wait for calls, as many as there have been at once. */
class CallThreads {
public:
    void execute(Job& job) {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (jobs_.size() >= idle_) begin();
        jobs_.push_back(&job);
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
            arrived_.wait(lock, [this] { return !jobs_.empty(); });
            Job& job = *jobs_.front();
            jobs_.pop_front();
            --idle_;
            lock.unlock();
            perform(job);
            lock.lock();
            ++idle_;
        }
    }
    static void perform(Job& job) {
        try {
            job.work();
        } catch (...) {
            job.thrown = std::current_exception();
        }
        // The waiting thread destroys the job as soon as it sees the state: only its address is used after that.
        job.state.store(1, std::memory_order_release);
        os::detail::futexWakeAll(job.state);
    }

    std::mutex mutex_;
    std::condition_variable arrived_;
    std::deque<Job*> jobs_;
    std::size_t idle_ = 0;
};

CallThreads& callThreads() {
    static auto* const threads = new CallThreads();  // never destroyed: its threads use it until the process ends
    return *threads;
}

}  // namespace

void executeElsewhere(const std::function<void()>& work) {
    Job job{work};
    callThreads().execute(job);
    while (job.state.load(std::memory_order_acquire) == 0) internal::EngineGate::sleepOn(job.state, 0);
    if (job.thrown) std::rethrow_exception(job.thrown);
}

}  // namespace RTT::corba::detail
