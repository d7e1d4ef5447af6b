// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DETAIL_LOG_OBSERVERS_HPP
#define RTT_DETAIL_LOG_OBSERVERS_HPP

#include <rtt/LogReceiver.hpp>

#include <mutex>
#include <vector>

namespace RTT {
namespace detail {

/** All observers of the log, as the one that LogSink knows while there are any. Never destroyed. */
class LogObservers final : private LogReceiver {
public:
    void add(LogReceiver& observer);
    void remove(LogReceiver& observer);

private:
    void receive(const LogEntry& entry) override;

    std::mutex changing_;  // held by add() and remove(), also while they wait for a line to be received
    std::mutex mutex_;     // for what follows; held while a line is received
    std::vector<LogReceiver*> all_;
};

LogObservers& logObservers();

}  // namespace detail
}  // namespace RTT
#endif
