// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LOGGING_RUNTIME_LOG_HPP
#define OROFORGE_LOGGING_RUNTIME_LOG_HPP

#include <ocl/Category.hpp>
#include <rtt/LogReceiver.hpp>

namespace OCL::logging {

/**
 * While it exists, the lines of the runtime's log are events of a category, too: the origin is the nested diagnostic
 * context of the event. The process has one at a time; a later one takes the place of the earlier.
 */
class RuntimeLog final : public RTT::LogReceiver {
public:
    explicit RuntimeLog(Category& category);
    /** Waits for the lines that were logged before, see RTT::Logger::setReceiver(). */
    ~RuntimeLog() override;

private:
    void receive(const RTT::LogEntry& entry) override;

    Category& category_;
};

}  // namespace OCL::logging

#endif
