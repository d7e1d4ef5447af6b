// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/detail/log_drain.hpp>

#include <rtt/detail/log_line.hpp>
#include <rtt/detail/log_sink.hpp>
#include <rtt/os/SignalsBlocked.hpp>

#include <csignal>

namespace RTT::detail {

void LogDrain::start() {
    std::lock_guard<std::mutex> lock(mutex_);
    if (running_) return;
    refillSpareLines();
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    // Explicit, because a real-time thread may create this one.
    pthread_attr_setinheritsched(&attributes, PTHREAD_EXPLICIT_SCHED);
    pthread_attr_setstacksize(&attributes, 256 * 1024);
    end_ = false;
    {
        const os::SignalsBlocked blocked;
        running_ = pthread_create(&thread_, &attributes, &LogDrain::run, this) == 0;
    }
    pthread_attr_destroy(&attributes);
    writeLogOnFatalSignals();
}

void LogDrain::stop() {
    std::lock_guard<std::mutex> lock(mutex_);
    if (!running_) return;
    running_ = false;
    end_ = true;
    wake();
    pthread_join(thread_, nullptr);
}

void LogDrain::afterFork(bool inChild) {
    if (inChild) running_ = due_ = false;
    mutex_.unlock();
}

void* LogDrain::run(void* self) {
    pthread_setname_np(pthread_self(), "log");
    auto& drain = *static_cast<LogDrain*>(self);
    while (!drain.end_) {
        drain.sleep_.wait();
        // Acquire: pairs with wake(). A line that is queued later sets the flag again.
        drain.due_.exchange(false, std::memory_order_acq_rel);
        logSink().drain();
        refillSpareLines();
    }
    return nullptr;
}

namespace {

constexpr int kFatalSignals[] = {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV};

void lastLines(int signal, siginfo_t* info, void*) {
    logSink().drainDying();
    // The default action is in force again. A fault repeats when this returns; a signal that was sent is raised again.
    if (info->si_code <= 0) raise(signal);
}

}  // namespace

void writeLogOnFatalSignals() {
    for (const int signal : kFatalSignals) {
        struct sigaction present {};
        const bool known = sigaction(signal, nullptr, &present) == 0;
        if (!known || (present.sa_flags & SA_SIGINFO) || present.sa_handler != SIG_DFL) continue;
        struct sigaction action {};
        action.sa_sigaction = &lastLines;
        action.sa_flags = static_cast<int>(SA_SIGINFO | SA_ONSTACK | SA_RESETHAND);
        sigemptyset(&action.sa_mask);
        sigaction(signal, &action, nullptr);
    }
}

}  // namespace RTT::detail
