// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "priorities.hpp"

#include <strings.h>

namespace OCL::logging {

std::optional<log4cpp::Priority::Value> priorityOf(const std::string& name) {
    for (const NamedPriority& priority : kPriorities)
        if (::strcasecmp(priority.name, name.c_str()) == 0) return priority.value;
    return std::nullopt;
}

const char* nameOf(log4cpp::Priority::Value value) {
    for (const NamedPriority& priority : kPriorities)
        if (priority.value == value) return priority.name;
    return nullptr;
}

}  // namespace OCL::logging
