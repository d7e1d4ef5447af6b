// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/detail/log_clock.hpp>

#include <cstdlib>
#include <ctime>

namespace RTT::detail {

namespace {

constexpr std::int64_t kNsPerMs = 1000000, kMsPerDay = 86400000;

std::int64_t floorDivision(std::int64_t a, std::int64_t b) noexcept { return a / b - (a % b < 0 ? 1 : 0); }

char* digits(char* out, std::int64_t number, int count) noexcept {
    for (char* at = out + count; at != out; number /= 10) *--at = static_cast<char>('0' + number % 10);
    return out + count;
}

}  // namespace

std::int64_t wallNow() noexcept {
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    return static_cast<std::int64_t>(now.tv_sec) * 1000000000 + now.tv_nsec;
}

int UtcOffset::at(std::int64_t wall) noexcept {
    const std::int64_t seconds = floorDivision(wall, 1000 * kNsPerMs);
    const std::int64_t quarter = floorDivision(seconds, 900);
    if (quarter == quarter_) return last();
    quarter_ = quarter;
    const auto moment = static_cast<std::time_t>(seconds);
    std::tm local{};
    // Without a known zone, local time is UTC.
    offset_ = localtime_r(&moment, &local) ? static_cast<int>(local.tm_gmtoff) : 0;
    return last();
}

char* formatWallTime(char* out, std::int64_t wall, int offset) noexcept {
    const std::int64_t ms = floorDivision(wall, kNsPerMs) + std::int64_t(offset) * 1000;
    const std::int64_t inDay = ms - floorDivision(ms, kMsPerDay) * kMsPerDay;
    // Days to the date, in years that begin with March, of which 400 have 146097 days.
    const std::int64_t days = floorDivision(ms, kMsPerDay) + 719468;
    const std::int64_t era = floorDivision(days, 146097), dayOfEra = days - era * 146097;
    const std::int64_t yearOfEra = (dayOfEra - dayOfEra / 1460 + dayOfEra / 36524 - dayOfEra / 146096) / 365;
    const std::int64_t dayOfYear = dayOfEra - (365 * yearOfEra + yearOfEra / 4 - yearOfEra / 100);
    const std::int64_t part = (5 * dayOfYear + 2) / 153, month = part < 10 ? part + 3 : part - 9;
    const std::int64_t minutes = std::abs(offset) / 60;

    const auto field = [&out](std::int64_t number, int count, char separator) {
        out = digits(out, number, count);
        *out++ = separator;
    };
    field(yearOfEra + era * 400 + (month <= 2 ? 1 : 0), 4, '-');
    field(month, 2, '-');
    field(dayOfYear - (153 * part + 2) / 5 + 1, 2, 'T');
    field(inDay / 3600000, 2, ':');
    field(inDay / 60000 % 60, 2, ':');
    field(inDay / 1000 % 60, 2, '.');
    field(inDay % 1000, 3, offset < 0 ? '-' : '+');
    field(minutes / 60, 2, ':');
    return digits(out, minutes % 60, 2);
}

}  // namespace RTT::detail
