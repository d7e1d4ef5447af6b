// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DETAIL_LOG_COLORS_HPP
#define RTT_DETAIL_LOG_COLORS_HPP

#include <rtt/Logger.hpp>

#include <ostream>
#include <string>

namespace RTT {
namespace detail {

/** Which consoles show levels in colours, and which colours these are. */
class LogColors {
public:
    enum When { Auto, Never, Always };
    /** Looks for NO_COLOR and TERM. */
    void begin(When when);
    /** Asked for each line, because the standard error stream may go elsewhere meanwhile. */
    bool on(const std::ostream& console) const noexcept;
    /** `line` with its level in colour into `out`. */
    static void paint(const std::string& line, LoggerLevel level, std::string& out);

private:
    When when_ = Never;
};

}  // namespace detail
}  // namespace RTT
#endif
