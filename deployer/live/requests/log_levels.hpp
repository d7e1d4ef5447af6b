// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_LOG_LEVELS_HPP
#define OROFORGE_LIVE_LOG_LEVELS_HPP

#include <rtt/Logger.hpp>

#include <string>

#include <strings.h>

namespace OCL::live {

/** By LoggerLevel. */
inline constexpr const char* kLogLevels[] = {"Never",   "Fatal", "Critical", "Error",
                                             "Warning", "Info",  "Debug",    "RealTime"};
inline constexpr const char* kLevelExpected = "'level' is none of Fatal, Critical, Error, Warning, Info and Debug";

/** False if the text is no level. */
inline bool parseLevel(const std::string& text, RTT::LoggerLevel& level) {
    for (int i = RTT::Never; i <= RTT::RealTime; ++i)
        if (::strcasecmp(kLogLevels[i], text.c_str()) == 0) {
            level = static_cast<RTT::LoggerLevel>(i);
            return true;
        }
    return false;
}

}  // namespace OCL::live

#endif
