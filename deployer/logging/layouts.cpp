// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "layouts.hpp"

#include <log4cpp/BasicLayout.hh>
#include <log4cpp/PatternLayout.hh>
#include <log4cpp/SimpleLayout.hh>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <ctime>

namespace OCL::logging {
namespace {

bool isControl(unsigned char c) { return (c < 0x20 && c != '\t') || c == 0x7f; }

/** Bytes that are no UTF-8 become U+FFFD. */
void appendJson(std::string& out, const std::string& text) {
    out += nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string isoTime(const log4cpp::TimeStamp& time) {
    const std::time_t seconds = static_cast<unsigned>(time.getSeconds());
    std::tm parts{};
    ::gmtime_r(&seconds, &parts);
    char text[64];
    std::snprintf(text, sizeof text, "%04d-%02d-%02dT%02d:%02d:%02d.%06dZ", parts.tm_year + 1900, parts.tm_mon + 1,
                  parts.tm_mday, parts.tm_hour, parts.tm_min, parts.tm_sec, time.getMicroSeconds());
    return text;
}

}  // namespace

std::string JsonLayout::format(const log4cpp::LoggingEvent& event) {
    std::string out = "{\"time\":\"" + isoTime(event.timeStamp) + "\",\"priority\":";
    appendJson(out, log4cpp::Priority::getPriorityName(event.priority));
    out += ",\"category\":";
    appendJson(out, event.categoryName);
    out += ",\"thread\":";
    appendJson(out, event.threadName);
    if (!event.ndc.empty()) {
        out += ",\"ndc\":";
        appendJson(out, event.ndc);
    }
    out += ",\"message\":";
    appendJson(out, event.message);
    out += "}\n";
    return out;
}

std::unique_ptr<log4cpp::Layout> makeLayout(const std::string& name, const std::string& pattern, std::string& error) {
    if (name.empty() || name == "basic") return std::make_unique<log4cpp::BasicLayout>();
    if (name == "simple") return std::make_unique<log4cpp::SimpleLayout>();
    if (name == "json") return std::make_unique<JsonLayout>();
    if (name != "pattern") {
        error = "expected basic, simple, pattern or json";
        return nullptr;
    }
    auto layout = std::make_unique<log4cpp::PatternLayout>();
    try {
        if (!pattern.empty()) layout->setConversionPattern(pattern);
    } catch (const std::exception& thrown) {
        error = "the pattern '" + pattern + "' is not valid: " + thrown.what();
        return nullptr;
    }
    return layout;
}

bool isPrintable(const std::string& text) {
    return std::none_of(text.begin(), text.end(), [](char c) { return isControl(static_cast<unsigned char>(c)); });
}

std::string printable(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '\n') {
            out += "\n    ";
        } else if (isControl(static_cast<unsigned char>(c))) {
            char code[8];
            std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned char>(c));
            out += code;
        } else {
            out += c;
        }
    }
    return out;
}

}  // namespace OCL::logging
