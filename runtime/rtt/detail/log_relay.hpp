// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DETAIL_LOG_RELAY_HPP
#define RTT_DETAIL_LOG_RELAY_HPP

#include <rtt/detail/log_format.hpp>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>

namespace RTT {

class LogReceiver;

namespace detail {

/** A line that waits for the receiver. */
struct LogCopy {
    LogCopy(const LogParts& line, bool alone) : parts(line), origin(line.module), text(line.text), only(alone) {}
    /** With its own texts. */
    LogParts line() const {
        LogParts result = parts;
        result.module = origin;
        result.text = text;
        return result;
    }
    LogParts parts;
    std::string origin, text;
    bool only;  // the file does not have it
};

/**
 * Calls the LogReceiver in a thread of its own, so that no thread that logs waits for it. All functions are
 * thread-safe; none is real-time safe. Never destroyed.
 */
class LogRelay {
public:
    typedef std::deque<LogCopy> Lines;
    /** What a receiver that is taken away did not get. */
    struct Rest {
        Lines lines;
        std::uint64_t lost = 0;  // lines for which there was no room
    };
    /** Called in the relay's thread with a line that only the receiver was to get and did not take, and with a
        warning. */
    struct Owner {
        virtual void notTaken(const LogParts& line) = 0;
        virtual void warn(const std::string& text) = 0;

    protected:
        ~Owner() = default;
    };
    explicit LogRelay(Owner& owner) : owner_(owner) {}

    /** False if there is no room, which is counted, or no receiver. */
    bool put(const LogParts& line, bool only);
    /** Waits until the receiver has got what is waiting, and knows of lost lines. False after a second. */
    bool deliver();
    /** The lines that are waiting, which the receiver does not get then. */
    Lines takeBack();
    bool isRunning() const noexcept { return running_.load(std::memory_order_relaxed); }
    /** Lines go to another receiver from now on, or to none. Returns the previous receiver, which may be in use still;
        `rest` gets what it did not get. */
    LogReceiver* exchange(LogReceiver* receiver, Rest& rest);
    /** Waits until the relay's thread does not use this receiver. */
    void awaitUnused(const LogReceiver* receiver);
    /** The same, at most a second. */
    void awaitUnusedBriefly(const LogReceiver* receiver);
    /** True in the thread that calls the receiver. Real-time safe. */
    bool inThread() const noexcept;
    /** For a signal handler: `show(line)` for each line that waits and that the file lacks, unless another thread is at
        the lines. */
    template <class Show>
    void rescue(Show show) {
        if (!mutex_.try_lock()) return;
        if (inProgress_ && inProgress_->only) show(inProgress_->line());
        for (const LogCopy& line : lines_)
            if (line.only) show(line.line());
        mutex_.unlock();
    }

    void beforeFork() { mutex_.lock(); }
    /** A child has neither the thread nor a receiver. */
    void afterFork(bool inChild);

private:
    typedef std::unique_lock<std::mutex> Lock;
    static constexpr std::size_t kMostLines = 1000;
    static constexpr std::chrono::seconds kPatience{1};
    static void* run(void* self);
    [[noreturn]] void loop();
    void give(Lock& lock);
    bool call(LogReceiver& receiver, const LogParts& line);
    void reportLost(Lock& lock);
    bool isUnused(const LogReceiver* receiver) const { return inThread() || busyWith_ != receiver; }

    Owner& owner_;
    std::atomic<bool> running_{false};
    std::atomic<unsigned long> thread_{0};

    std::mutex mutex_;  // for what follows
    std::condition_variable changed_;
    LogReceiver* receiver_ = nullptr;
    const LogReceiver* busyWith_ = nullptr;  // what the thread calls now
    const LogCopy* inProgress_ = nullptr;    // the line of that call
    Lines lines_;
    std::uint64_t put_ = 0, given_ = 0;  // lines since the beginning
    std::uint64_t lost_ = 0;             // since the last warning
    bool threw_ = false;                 // this receiver
};

}  // namespace detail
}  // namespace RTT
#endif
