// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The state of a LoggingService, for LoggingService.cpp and logging_setup.cpp.
#ifndef OROFORGE_LOGGING_LOGGING_STATE_HPP
#define OROFORGE_LOGGING_LOGGING_STATE_HPP

#include "runtime_log.hpp"

#include <ocl/Category.hpp>
#include <ocl/LoggingService.hpp>
#include <rtt/internal/values/newer_properties.hpp>
#include <rtt/PropertyBag.hpp>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace OCL::logging {

struct LoggingService::Impl {
    explicit Impl(LoggingService& service) : self(service) {}

    struct Connection {
        std::string category, appender;
    };

    // Each reports all errors and returns false if there are any.
    bool checkSizes() const;
    bool setLevels() const;
    bool setAdditivity() const;
    bool connectAppenders();
    bool connectRuntimeLog();

    bool connect(const std::string& category, const std::string& appender);
    void disconnect();
    /** Has real-time memory for one more connection. */
    bool hasMemory(const std::string& category) const;

    LoggingService& self;
    /** Files for OCL have none of these. */
    const RTT::internal::NewerProperties newer{*self.properties(), {"BufferSize", "MessageSize", "RuntimeCategory"}};
    RTT::PropertyBag levels, additivity, appenders;
    int bufferSize = 100;
    int messageSize = 200;
    std::string runtimeCategory;
    std::unique_ptr<RuntimeLog> runtimeLog;
    std::mutex mutex;  // guards the connections
    std::vector<Connection> connections;
};

/** "category 'a.b'" or "the root category". */
std::string described(const std::string& category);

}  // namespace OCL::logging

#endif
