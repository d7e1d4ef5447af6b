// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Priorities of log4cpp by name.
#ifndef OROFORGE_LOGGING_PRIORITIES_HPP
#define OROFORGE_LOGGING_PRIORITIES_HPP

#include <log4cpp/Priority.hh>

#include <optional>
#include <string>

namespace OCL::logging {

struct NamedPriority {
    const char* name;
    log4cpp::Priority::Value value;
};
inline constexpr NamedPriority kPriorities[] = {
    {"EMERG", log4cpp::Priority::EMERG},   {"FATAL", log4cpp::Priority::FATAL}, {"ALERT", log4cpp::Priority::ALERT},
    {"CRIT", log4cpp::Priority::CRIT},     {"ERROR", log4cpp::Priority::ERROR}, {"WARN", log4cpp::Priority::WARN},
    {"NOTICE", log4cpp::Priority::NOTICE}, {"INFO", log4cpp::Priority::INFO},   {"DEBUG", log4cpp::Priority::DEBUG},
    {"NOTSET", log4cpp::Priority::NOTSET},
};

/** In upper or lower case. */
std::optional<log4cpp::Priority::Value> priorityOf(const std::string& name);
/** Null if no priority has that value. */
const char* nameOf(log4cpp::Priority::Value priority);

}  // namespace OCL::logging

#endif
