// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_SYSLOG_APPENDER_HPP
#define ORO_OCL_SYSLOG_APPENDER_HPP

#include <ocl/Appender.hpp>

namespace OCL {
namespace logging {

/**
 * Sends events to the log of the system, with the name Identity and the facility that Facility names ("user", "daemon",
 * "local0" to "local7" and so on). Without a daemon that takes them, events are counted and lost. The property Socket
 * is for tests and containers.
 */
class OCL_API SyslogAppender : public Appender {
public:
    explicit SyslogAppender(std::string name);
    ~SyslogAppender() override;

protected:
    bool configureHook() override;
    void updateHook() override;

    RTT::Property<std::string> identity_prop;
    RTT::Property<std::string> facility_prop;
    RTT::Property<std::string> socket_prop;
    RTT::Property<int> maxEventsPerCycle_prop;
};

}  // namespace logging
}  // namespace OCL

#endif
