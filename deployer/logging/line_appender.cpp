// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "line_appender.hpp"

#include <rtt/Logger.hpp>

namespace OCL::logging {

void LineAppender::_append(const log4cpp::LoggingEvent& event) {
    std::string record = _getLayout().format(event);
    if (record.empty() || record.back() != '\n') record += '\n';
    write(event, record);
}

void LineAppender::failed(std::size_t events, const std::string& reason) {
    lost_ += events;
    lostNow_ += events;
    if (fails_) return;
    fails_ = true;
    RTT::log(RTT::Error) << "appender '" << owner_ << "' cannot write to " << target() << ": " << reason
                         << "; until it can, events are counted and lost" << RTT::endlog();
}

void LineAppender::succeeded() {
    if (!fails_) return;
    fails_ = false;
    RTT::log(RTT::Warning) << "appender '" << owner_ << "' can write to " << target() << " again; " << lostNow_
                           << " events were lost" << RTT::endlog();
    lostNow_ = 0;
}

void LineAppender::reportLost() {
    if (!fails_) return;
    fails_ = false;
    RTT::log(RTT::Error) << "appender '" << owner_ << "' has lost " << lostNow_
                         << " events, which it could not write to " << target() << RTT::endlog();
    lostNow_ = 0;
}

}  // namespace OCL::logging
