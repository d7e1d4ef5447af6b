// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The verb `lines`: what the log file ends with.
#include "failure.hpp"
#include "fields.hpp"
#include "log_levels.hpp"
#include "verbs.hpp"

#include <rtt/internal/log_file_name.hpp>
#include <rtt/os/TimeService.hpp>
#include <rtt/os/descriptor.hpp>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string_view>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace OCL::live {
namespace {

using nlohmann::json;

constexpr std::size_t kMostLines = 10000, kUsualLines = 20;
constexpr off_t kMostBytes = off_t(1) << 20;
constexpr std::size_t kTag = 10, kLongestTime = 30;  // of a line: "12.345 [ Warning][Arm] text"

struct Line {
    std::int64_t time = 0;  // ns since 1970
    RTT::LoggerLevel level = RTT::Info;
    std::string origin, text;
};

/** The end of a file, from the beginning of a line on. */
std::string endOf(const std::string& name) {
    const RTT::os::detail::Descriptor file(::open(name.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status {};
    if (!file || ::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
    const off_t begin = std::max<off_t>(0, status.st_size - kMostBytes);
    std::string text(static_cast<std::size_t>(status.st_size - begin), '\0');
    std::size_t size = 0;
    for (ssize_t got = 1; size != text.size() && got > 0; size += static_cast<std::size_t>(std::max<ssize_t>(got, 0)))
        got = ::pread(file.get(), &text[size], text.size() - size, begin + static_cast<off_t>(size));
    text.resize(size);
    if (begin != 0) text.erase(0, text.find('\n') + 1);
    return text;
}

/** The time in front of a line: seconds since the reference time, or "2026-03-29T14:37:49.123+02:00". */
std::int64_t timeOf(const std::string& text, std::int64_t reference) {
    std::tm parts{};
    int ms = 0, hours = 0, minutes = 0;
    char sign = '+';
    if (std::sscanf(text.c_str(), "%d-%d-%dT%d:%d:%d.%d%c%d:%d", &parts.tm_year, &parts.tm_mon, &parts.tm_mday,
                    &parts.tm_hour, &parts.tm_min, &parts.tm_sec, &ms, &sign, &hours, &minutes) != 10)
        return reference + static_cast<std::int64_t>(std::strtod(text.c_str(), nullptr) * 1e9);
    parts.tm_year -= 1900;
    parts.tm_mon -= 1;
    const std::int64_t offset = (sign == '-' ? -1 : 1) * (std::int64_t(hours) * 3600 + std::int64_t(minutes) * 60);
    return (std::int64_t(timegm(&parts)) - offset) * 1000000000 + std::int64_t(ms) * 1000000;
}

/** False if the text is not the first line of an entry: the entry goes on, or it is the text alone. */
bool parse(std::string_view text, std::int64_t reference, Line& line) {
    const std::size_t space = text.find(" [");
    if (space == std::string_view::npos || space > kLongestTime || text.size() < space + 1 + kTag + 2) return false;
    if (!std::isdigit(static_cast<unsigned char>(text[0])) && text[0] != '-') return false;
    std::string level;
    for (const char c : text.substr(space + 2, kTag - 2))
        if (c != ' ') level += c;
    const std::size_t origin = space + 1 + kTag + 1, end = text.find("] ", origin);
    if (text[origin - 1] != '[' || end == std::string_view::npos || !parseLevel(level, line.level)) return false;
    line.time = timeOf(std::string(text.substr(0, space)), reference);
    line.origin = text.substr(origin, end - origin);
    line.text = text.substr(end + 2);
    return true;
}

std::vector<Line> linesOf(const std::string& text, std::int64_t reference) {
    std::vector<Line> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view one = std::string_view(text).substr(at, end - at);
        at = end + 1;
        Line line;
        if (parse(one, reference, line)) {
            lines.push_back(std::move(line));
        } else if (!lines.empty() && one.substr(0, 4) == "    ") {
            lines.back().text += "\n" + std::string(one.substr(4));
        } else {
            // Errors of a compiler's form, which have a place instead.
            line.time = lines.empty() ? reference : lines.back().time;
            line.level = one.find(": error:") != std::string_view::npos     ? RTT::Error
                         : one.find(": warning:") != std::string_view::npos ? RTT::Warning
                                                                            : RTT::Info;
            line.text = one;
            lines.push_back(std::move(line));
        }
    }
    return lines;
}

/** The reference time of the log, in ns since 1970. */
std::int64_t referenceTime() {
    using namespace std::chrono;
    const std::int64_t now = duration_cast<nanoseconds>(system_clock::now().time_since_epoch()).count();
    return now - RTT::os::TimeService::Instance()->getNSecs(RTT::Logger::Instance()->getReferenceTime());
}

}  // namespace

json lines(const Asked& asked) {
    const auto last = asked.request.find("last");
    if (last != asked.request.end() && !(last->is_number_integer() && *last >= 0 && *last <= kMostLines))
        throw Failure(kMalformed, "'last' is not a number of lines, at most 10000");
    const auto count = last == asked.request.end() ? kUsualLines : last->get<std::size_t>();
    RTT::LoggerLevel level = RTT::RealTime;
    const std::string wanted = textField(asked.request, "level", "");
    if (!wanted.empty() && !parseLevel(wanted, level)) throw Failure(kMalformed, kLevelExpected);
    const std::string file = RTT::internal::flushedLogFile();
    std::vector<Line> all;
    if (!file.empty()) all = linesOf(endOf(file), referenceTime());
    all.erase(std::remove_if(all.begin(), all.end(), [level](const Line& one) { return one.level > level; }),
              all.end());
    json made = json::array();
    for (std::size_t i = all.size() - std::min(all.size(), count); i != all.size(); ++i)
        made.push_back({{"time", all[i].time},
                        {"level", kLogLevels[all[i].level]},
                        {"origin", all[i].origin},
                        {"text", all[i].text}});
    return {{"file", file}, {"lines", std::move(made)}};
}

}  // namespace OCL::live
