// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/detail/log_relay.hpp>

#include <rtt/LogReceiver.hpp>
#include <rtt/detail/log_clock.hpp>
#include <rtt/os/SignalsBlocked.hpp>

#include <exception>
#include <new>
#include <utility>

#include <pthread.h>

namespace RTT::detail {

namespace {

/** Of ordinary priority, whatever that of this thread is. Detached: nobody waits for its end. */
bool startThread(void* (*run)(void*), void* self) {
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setinheritsched(&attributes, PTHREAD_EXPLICIT_SCHED);
    pthread_attr_setdetachstate(&attributes, PTHREAD_CREATE_DETACHED);
    const os::SignalsBlocked blocked;
    pthread_t thread{};
    const bool started = pthread_create(&thread, &attributes, run, self) == 0;
    pthread_attr_destroy(&attributes);
    return started;
}

}  // namespace

bool LogRelay::put(const LogParts& line, bool only) {
    const Lock lock(mutex_);
    if (!receiver_ || !running_) return false;
    if (lines_.size() >= kMostLines) {
        ++lost_;
        return false;
    }
    lines_.emplace_back(line, only);
    ++put_;
    changed_.notify_all();
    return true;
}

bool LogRelay::deliver() {
    if (inThread()) return true;
    Lock lock(mutex_);
    const std::uint64_t last = put_;
    return changed_.wait_for(lock, kPatience, [&] { return !receiver_ || (given_ >= last && lost_ == 0); });
}

LogRelay::Lines LogRelay::takeBack() {
    const Lock lock(mutex_);
    Lines rest;
    given_ += lines_.size();
    rest.swap(lines_);
    changed_.notify_all();
    return rest;
}

LogReceiver* LogRelay::exchange(LogReceiver* receiver, Rest& rest) {
    const Lock lock(mutex_);
    LogReceiver* const previous = std::exchange(receiver_, receiver);
    if (previous != receiver) {
        given_ += lines_.size();
        rest.lines.swap(lines_);
        rest.lost = std::exchange(lost_, 0);
        threw_ = false;
    }
    if (receiver && !running_) running_ = startThread(&LogRelay::run, this);
    changed_.notify_all();
    return previous;
}

void LogRelay::awaitUnused(const LogReceiver* receiver) {
    Lock lock(mutex_);
    changed_.wait(lock, [&] { return isUnused(receiver); });
}

void LogRelay::awaitUnusedBriefly(const LogReceiver* receiver) {
    Lock lock(mutex_);
    changed_.wait_for(lock, kPatience, [&] { return isUnused(receiver); });
}

bool LogRelay::inThread() const noexcept {
    return running_.load(std::memory_order_relaxed) && thread_.load(std::memory_order_relaxed) == pthread_self();
}

void LogRelay::afterFork(bool inChild) {
    if (inChild) {
        new (&changed_) std::condition_variable;  // threads of the parent may be waiting in it
        running_ = false;
        thread_ = 0;
        receiver_ = nullptr;
        busyWith_ = nullptr;
        inProgress_ = nullptr;
        lines_.clear();
        given_ = put_;
        lost_ = 0;
    }
    mutex_.unlock();
}

void* LogRelay::run(void* self) {
    pthread_setname_np(pthread_self(), "log receiver");
    auto& relay = *static_cast<LogRelay*>(self);
    relay.thread_ = pthread_self();
    relay.loop();
}

void LogRelay::loop() {
    for (Lock lock(mutex_);;) {
        changed_.wait(lock, [&] { return receiver_ && !lines_.empty(); });
        give(lock);
        if (lost_ != 0 && lines_.empty() && receiver_) reportLost(lock);
    }
}

/** The oldest line to the receiver. */
void LogRelay::give(Lock& lock) {
    LogReceiver* const receiver = receiver_;
    const LogCopy copy = std::move(lines_.front());
    lines_.pop_front();
    busyWith_ = receiver;
    inProgress_ = &copy;
    lock.unlock();
    const bool taken = call(*receiver, copy.line());
    if (!taken && copy.only) owner_.notTaken(copy.line());
    lock.lock();
    busyWith_ = nullptr;
    inProgress_ = nullptr;
    ++given_;
    changed_.notify_all();
}

bool LogRelay::call(LogReceiver& receiver, const LogParts& line) {
    std::string why;
    try {
        receiver.receive({line.level, line.module, line.text, line.cut, line.time, line.wall, line.bare});
        return true;
    } catch (const std::exception& thrown) {
        why = thrown.what();
    } catch (...) {
        why = "something that is no std::exception";
    }
    bool first = false;
    {
        const Lock lock(mutex_);
        first = receiver_ == &receiver && !std::exchange(threw_, true);
    }
    if (first) owner_.warn("the receiver of the log threw: " + why + "; it does not get that line again");
    return false;
}

void LogRelay::reportLost(Lock& lock) {
    LogReceiver* const receiver = receiver_;
    const std::string text = std::to_string(std::exchange(lost_, 0)) +
                             " line(s) not given to the receiver of the log, which was too slow: 1000 were waiting";
    LogParts line{Warning, "Logger", text};
    line.time = os::TimeService::Instance()->getTicks(Logger::Instance()->getReferenceTime());
    line.wall = wallNow();
    busyWith_ = receiver;
    lock.unlock();
    owner_.warn(text);
    (void)call(*receiver, line);
    lock.lock();
    busyWith_ = nullptr;
    changed_.notify_all();
}

}  // namespace RTT::detail
