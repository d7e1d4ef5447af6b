// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/detail/log_settings.hpp>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace RTT::detail {

namespace {

constexpr unsigned long long kMostKept = 1000;

/** Null if it is not set, or empty. */
const char* variable(const char* name) {
    const char* const text = std::getenv(name);
    return text && *text ? text : nullptr;
}

std::string fault(const char* name, const char* text, const std::string& rest) {
    return std::string("environment variable ") + name + " is '" + text + "', expected " + rest;
}

/** Decimal digits at the beginning of `text`, which then begins behind them. */
std::optional<unsigned long long> takeNumber(const char*& text) {
    if (*text < '0' || *text > '9') return std::nullopt;
    char* end = nullptr;
    errno = 0;
    const unsigned long long number = std::strtoull(text, &end, 10);
    text = end;
    if (errno != 0) return std::nullopt;
    return number;
}

std::optional<std::uint64_t> sizeOf(const char* text) {
    const auto number = takeNumber(text);
    if (!number) return std::nullopt;
    constexpr std::string_view units = "kmg";
    unsigned shift = 0;
    if (*text) {
        const std::size_t unit = units.find(static_cast<char>(*text | 0x20));
        if (unit == std::string_view::npos || text[1] != '\0') return std::nullopt;
        shift = 10 * (static_cast<unsigned>(unit) + 1);
    }
    if (*number > UINT64_MAX >> shift) return std::nullopt;
    return *number << shift;
}

void readLevel(LogSettings& settings) {
    const char* const text = variable("ORO_LOGLEVEL");
    if (!text) {
        settings.notes.emplace_back(Info, "environment variable ORO_LOGLEVEL is not set");
        return;
    }
    char* end = nullptr;
    errno = 0;
    const long number = std::strtol(text, &end, 10);
    if (end == text || *end != '\0' || errno != 0) {
        settings.notes.emplace_back(Error, fault("ORO_LOGLEVEL", text, "a number from 0 (Never) to 6 (Debug)"));
        return;
    }
    // The variable cannot select RealTime: more than Debug means Debug.
    settings.level = number < 0 ? -1 : number > Debug ? int(Debug) : static_cast<int>(number);
    settings.notes.emplace_back(Info, "log level taken from environment variable ORO_LOGLEVEL");
}

void readTime(LogSettings& settings) {
    const char* const text = variable("ORO_LOGTIME");
    if (!text) return;
    if (std::strcmp(text, "wall") == 0)
        settings.time = LogTime::Wall;
    else if (std::strcmp(text, "relative") == 0)
        settings.time = LogTime::Relative;
    else
        settings.notes.emplace_back(Warning, fault("ORO_LOGTIME", text, "'relative' or 'wall'"));
}

void readColors(LogSettings& settings) {
    const char* const text = variable("ORO_LOGCOLOR");
    if (!text || std::strcmp(text, "auto") == 0) return;
    if (std::strcmp(text, "never") == 0)
        settings.colors = LogColors::Never;
    else if (std::strcmp(text, "always") == 0)
        settings.colors = LogColors::Always;
    else
        settings.notes.emplace_back(Warning, fault("ORO_LOGCOLOR", text, "'auto', 'never' or 'always'"));
}

void readFile(LogSettings& settings) {
    LogFileRules& file = settings.file;
    if (const char* const text = variable("ORO_LOGFILE")) {
        file.name = text;
        file.named = true;
    }
    if (const char* const text = variable("ORO_LOGFILE_KEEP")) {
        const char* at = text;
        const auto number = takeNumber(at);
        if (number && *at == '\0' && *number <= kMostKept)
            file.keep = static_cast<unsigned>(*number);
        else
            settings.notes.emplace_back(
                Warning, fault("ORO_LOGFILE_KEEP", text, "a number of files from 0 to 1000; 3 are kept"));
    }
    if (const char* const text = variable("ORO_LOGFILE_MAX")) {
        if (const auto size = sizeOf(text))
            file.most = *size;
        else
            settings.notes.emplace_back(
                Warning, fault("ORO_LOGFILE_MAX", text, "a number of bytes, or one with k, m or g; there is no limit"));
    }
}

}  // namespace

LogSettings readLogSettings() {
    LogSettings settings;
    readLevel(settings);
    readTime(settings);
    readColors(settings);
    readFile(settings);
    return settings;
}

}  // namespace RTT::detail
