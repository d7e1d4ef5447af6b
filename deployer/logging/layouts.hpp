// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Layouts by name.
#ifndef OROFORGE_LOGGING_LAYOUTS_HPP
#define OROFORGE_LOGGING_LAYOUTS_HPP

#include <log4cpp/Layout.hh>

#include <memory>
#include <string>

namespace OCL::logging {

/** One JSON object per line. */
class JsonLayout final : public log4cpp::Layout {
public:
    std::string format(const log4cpp::LoggingEvent& event) override;
};

/** The layout "", "basic", "simple", "pattern" or "json"; null, with the reason, for other names and for patterns that
    log4cpp does not know. */
std::unique_ptr<log4cpp::Layout> makeLayout(const std::string& name, const std::string& pattern, std::string& error);

/** The text without control characters that would let it pass for another record; what follows a line end is
    indented. */
std::string printable(const std::string& text);
/** Is there anything that printable() changes? */
bool isPrintable(const std::string& text);

}  // namespace OCL::logging

#endif
