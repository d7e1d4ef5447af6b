// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DETAIL_LOG_SETTINGS_HPP
#define RTT_DETAIL_LOG_SETTINGS_HPP

#include <rtt/Logger.hpp>
#include <rtt/detail/log_colors.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace RTT {
namespace detail {

/** A message about the log itself. */
typedef std::pair<LoggerLevel, std::string> LogNote;
typedef std::vector<LogNote> LogNotes;

/** How the log file is named and limited. */
struct LogFileRules {
    std::string name = "orocos.log";
    bool named = false;      // by ORO_LOGFILE
    unsigned keep = 3;       // earlier files
    std::uint64_t most = 0;  // bytes; 0: no limit
};

/** What the environment says about the log; nothing where a variable is not set or cannot be read. */
struct LogSettings {
    std::optional<int> level;
    std::optional<LogTime> time;
    LogColors::When colors = LogColors::Auto;
    LogFileRules file;
    LogNotes notes;  // how the level was found, and values that cannot be read
};
LogSettings readLogSettings();

}  // namespace detail
}  // namespace RTT
#endif
