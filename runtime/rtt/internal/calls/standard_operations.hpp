// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The operations that every component has.
#ifndef ORO_INTERNAL_STANDARD_OPERATIONS_HPP
#define ORO_INTERNAL_STANDARD_OPERATIONS_HPP

#include <algorithm>
#include <iterator>
#include <string>

namespace RTT {
namespace internal {

struct StandardOperation {
    const char* name;
    bool isQuery;         ///< executes no code of the component
    bool isUnmistakable;  ///< other operations have no similar name, as `step` is to `stop`
};

inline constexpr StandardOperation kStandardOperations[] = {
    {"activate", false, true},    {"cleanup", false, true},        {"configure", false, true},
    {"error", false, false},      {"getCpuAffinity", true, false}, {"getPeriod", true, false},
    {"inException", true, false}, {"inFatalError", true, false},   {"inRunTimeError", true, false},
    {"isActive", true, true},     {"isConfigured", true, true},    {"isRunning", true, true},
    {"loadService", false, true}, {"setCpuAffinity", true, false}, {"setPeriod", true, true},
    {"start", false, false},      {"stop", false, false},          {"trigger", false, true},
    {"update", false, false},
};

/** Null if `name` is not one of them. */
inline const StandardOperation* standardOperation(const std::string& name) {
    const auto found = std::find_if(std::begin(kStandardOperations), std::end(kStandardOperations),
                                    [&](const StandardOperation& each) { return name == each.name; });
    return found == std::end(kStandardOperations) ? nullptr : found;
}

}  // namespace internal
}  // namespace RTT

#endif
