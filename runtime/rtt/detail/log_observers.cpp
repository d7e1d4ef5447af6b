// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/detail/log_observers.hpp>

#include <rtt/detail/log_sink.hpp>

#include <algorithm>
#include <exception>

namespace RTT {
namespace detail {

void LogObservers::add(LogReceiver& observer) {
    const std::lock_guard<std::mutex> changing(changing_);
    bool isFirst = false;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (std::find(all_.begin(), all_.end(), &observer) != all_.end()) return;
        isFirst = all_.empty();
        all_.push_back(&observer);
    }
    if (isFirst) logSink().setObserver(this);
}

void LogObservers::remove(LogReceiver& observer) {
    const std::lock_guard<std::mutex> changing(changing_);
    bool isLast = false;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (std::find(all_.begin(), all_.end(), &observer) == all_.end()) return;
        isLast = all_.size() == 1;
    }
    // It gets what was logged before.
    if (isLast)
        logSink().setObserver(nullptr);
    else
        logSink().deliverToObserver();
    const std::lock_guard<std::mutex> lock(mutex_);
    all_.erase(std::remove(all_.begin(), all_.end(), &observer), all_.end());
}

void LogObservers::receive(const LogEntry& entry) {
    std::exception_ptr thrown;
    const std::lock_guard<std::mutex> lock(mutex_);
    for (LogReceiver* const one : all_) try {
            one->receive(entry);
        } catch (...) {
            thrown = std::current_exception();  // the others get the line, too
        }
    if (thrown) std::rethrow_exception(thrown);
}

LogObservers& logObservers() {
    static LogObservers& all = *new LogObservers;
    return all;
}

}  // namespace detail

void addLogObserver(LogReceiver& observer) {
    Logger::Instance();
    detail::logObservers().add(observer);
}

void removeLogObserver(LogReceiver& observer) { detail::logObservers().remove(observer); }

}  // namespace RTT
