// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/SyslogAppender.hpp>

#include "layouts.hpp"
#include "syslog_lines.hpp"

#include <rtt/Logger.hpp>

namespace OCL::logging {

SyslogAppender::SyslogAppender(std::string name)
    : Appender(name),
      identity_prop("Identity", "The name that events have in the system's log; that of the component if it is empty."),
      facility_prop("Facility", "Their facility: user, daemon, local0 to local7 or another one of syslog(3).", "user"),
      socket_prop("Socket", "Where the daemon of the system's log receives.", "/dev/log"),
      maxEventsPerCycle_prop("MaxEventsPerCycle", "How many events a cycle takes at most; 0 for all.", 0) {
    // The daemon adds time and priority.
    layoutName_prop = "pattern";
    layoutPattern_prop = "%c: %m";
    addProperty(identity_prop);
    addProperty(facility_prop);
    addProperty(socket_prop);
    addProperty(maxEventsPerCycle_prop);
}

SyslogAppender::~SyslogAppender() { stopForGood(); }

bool SyslogAppender::configureHook() {
    if (!isMaxEvents(maxEventsPerCycle_prop.get())) return false;
    const std::optional<int> facility = facilityOf(facility_prop.get());
    if (!facility) {
        RTT::log(RTT::Error) << "appender '" << getName() << "': '" << facility_prop.get()
                             << "' is no facility of syslog(3); expected user, daemon, local0 to local7 or another one"
                             << RTT::endlog();
        return false;
    }
    const std::string identity = identity_prop.get().empty() ? getName() : identity_prop.get();
    hold(std::make_unique<SyslogLines>(getName(), printable(identity), *facility, socket_prop.get()));
    return configureLayout();
}

void SyslogAppender::updateHook() { processEvents(maxEventsPerCycle_prop.get()); }

}  // namespace OCL::logging
