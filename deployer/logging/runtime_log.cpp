// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "runtime_log.hpp"

#include <string>

namespace OCL::logging {
namespace {

constexpr std::int64_t kSecond = 1000000000;
constexpr std::int64_t kMicrosecond = 1000;

log4cpp::Priority::Value priorityFor(RTT::LoggerLevel level) {
    switch (level) {
        case RTT::Never:
        case RTT::Fatal: return log4cpp::Priority::FATAL;
        case RTT::Critical: return log4cpp::Priority::CRIT;
        case RTT::Error: return log4cpp::Priority::ERROR;
        case RTT::Warning: return log4cpp::Priority::WARN;
        case RTT::Info: return log4cpp::Priority::INFO;
        case RTT::Debug:
        case RTT::RealTime: return log4cpp::Priority::DEBUG;
    }
    return log4cpp::Priority::DEBUG;
}

}  // namespace

RuntimeLog::RuntimeLog(Category& category) : category_(category) { RTT::Logger::Instance()->setReceiver(this); }

RuntimeLog::~RuntimeLog() {
    RTT::LogReceiver* const present = RTT::Logger::Instance()->setReceiver(nullptr);
    if (present != this) RTT::Logger::Instance()->setReceiver(present);
}

void RuntimeLog::receive(const RTT::LogEntry& entry) {
    const log4cpp::Priority::Value priority = priorityFor(entry.level);
    if (!category_.isPriorityEnabled(priority)) return;
    std::string message(entry.text);
    if (entry.cut != 0) message += " … (" + std::to_string(entry.cut) + " more characters)";
    LoggingEvent event;
    event.setCategory(category_.rtName_);
    event.setMessage(message.data(), message.size());
    event.ndc.assign(entry.origin.data(), entry.origin.size());
    event.priority = priority;
    event.threadName = event.ndc;
    event.timeStamp = log4cpp::TimeStamp(static_cast<unsigned int>(entry.wallTime / kSecond),
                                         static_cast<unsigned int>(entry.wallTime % kSecond / kMicrosecond));
    category_.callAppenders(event);
}

}  // namespace OCL::logging
