// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// oro hz and delay
#include "follow.hpp"

#include "failure.hpp"
#include "statistics.hpp"
#include "value_text.hpp"

#include <cmath>
#include <cstdio>
#include <ctime>
#include <optional>

namespace oroforge::live_client {
namespace {

constexpr double kNanosecond = 1e-9;
constexpr long long kSamplesQueued = 4096;  // in the deployment between two of its looks at the port

std::string number(double value, int digits = 4) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

/** "0.0123 s" as "12.3 ms". */
std::string duration(double seconds) {
    const double size = std::fabs(seconds);
    if (size >= 1) return number(seconds) + " s";
    if (size >= 1e-3) return number(seconds * 1e3) + " ms";
    return number(seconds * 1e6) + " us";
}

double now(clockid_t clock) {
    timespec time = {};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * kNanosecond;
}

std::optional<double> parts(const Json& value, const char* seconds, const char* rest, double scale) {
    const auto whole = asNumber(memberOf(value, seconds)), fraction = asNumber(memberOf(value, rest));
    if (!whole || !fraction) return std::nullopt;
    return *whole + *fraction * scale;
}

/** The time stamp in seconds: of a number of seconds or nanoseconds, or of a struct such as ROS and iceoryx have. */
std::optional<double> stampOf(const Json& value) {
    constexpr double kMostSeconds = 1e11;  // larger numbers count nanoseconds
    if (const auto plain = asNumber(value)) return std::fabs(*plain) < kMostSeconds ? *plain : *plain * kNanosecond;
    for (const char* const rest : {"nsec", "nsecs", "nanosec", "nanoseconds"})
        for (const char* const whole : {"sec", "secs", "seconds"})
            if (const auto stamp = parts(value, whole, rest, kNanosecond)) return stamp;
    if (const auto stamp = parts(value, "sec", "usec", 1e-6)) return stamp;
    if (const auto stamp = asNumber(memberOf(value, "microseconds"))) return *stamp * 1e-6;
    if (const auto stamp = asNumber(memberOf(value, "nanoseconds"))) return *stamp * kNanosecond;
    return std::nullopt;
}

/** Where time stamps usually are; the value itself if it is one. */
const Json& stampIn(const Json& value) {
    for (const char* const path : {"header.stamp", "stamp", "timestamp", "time"}) {
        const Json* const found = memberAt(value, path);
        if (found && stampOf(*found)) return *found;
    }
    return value;
}

Json asJson(const Statistics& all) {
    return {{"count", all.count()},
            {"mean", all.mean()},
            {"min", all.least()},
            {"max", all.greatest()},
            {"deviation", all.deviation()}};
}

std::string spread(const Statistics& all) {
    return "min " + duration(all.least()) + "  max " + duration(all.greatest()) + "  deviation " +
           duration(all.deviation());
}

/** How often samples came. */
class Rate {
public:
    explicit Rate(Session& session) : session_(session) {}

    void add(const Json& message) {
        const double time = static_cast<double>(wholeOf(message, "time") - first(message)) * kNanosecond;
        dropped_ = wholeOf(message, "dropped");  // in all
        if (samples_++) intervals_.add(time - last_);
        last_ = time;
    }
    void write(const char* title) const {
        const double rate = last_ > 0 ? static_cast<double>(samples_ - 1 + dropped_) / last_ : 0;
        if (session_.json()) {
            return session_.out().line(lineOf(
                {{"rate", rate}, {"samples", samples_}, {"dropped", dropped_}, {"interval", asJson(intervals_)}}));
        }
        if (samples_ < 2)
            return session_.out().line(samples_ ? "one sample, so there is no rate yet" : "no sample yet");
        session_.out().line(title + number(rate, 6) + " Hz  interval " + spread(intervals_) + "  " +
                            std::to_string(samples_) + " samples" +
                            (dropped_ ? ", " + std::to_string(dropped_) + " dropped" : ""));
    }

private:
    long long first(const Json& message) {
        if (!samples_) first_ = wholeOf(message, "time");
        return first_;
    }

    Session& session_;
    Statistics intervals_;
    long long first_ = 0, samples_ = 0, dropped_ = 0;
    double last_ = 0;  // seconds since the first one
};

/** Ends after --count reports; 0: never. */
std::function<bool()> reports(Session& session, std::function<void()> write) {
    const double count = session.given().number("count", 0, 1, 1e9);
    return [write = std::move(write), left = count, counts = count > 0]() mutable {
        write();
        return !counts || --left > 0;
    };
}

std::chrono::milliseconds intervalOf(Session& session) {
    return std::chrono::milliseconds(std::llround(session.given().number("interval", 1, 0.01, 86400) * 1000));
}

}  // namespace

void showRate(Session& session) {
    Rate rate(session);
    bool last = false;
    const auto report = reports(session, [&] { rate.write(""); });
    followPort(
        session, {{"buffer", kSamplesQueued}, {"times", true}},
        [&](const Json& message, const Json&) {
            rate.add(message);
            return true;
        },
        [&] {
            last = !report();
            return !last;
        },
        intervalOf(session));
    if (!last) rate.write(session.json() ? "" : "in all: ");
}

void showDelay(Session& session) {
    Statistics delays;
    // Stamps of a monotonic clock are small, compared with the seconds since 1970.
    constexpr double kMonotonic = 5e8;
    const auto write = [&](const char* title) {
        if (session.json()) return session.out().line(lineOf(asJson(delays)));
        if (delays.count() == 0) return session.out().line("no sample yet");
        session.out().line(title + duration(delays.mean()) + "  " + spread(delays) + "  " +
                           std::to_string(delays.count()) + " samples");
    };
    bool last = false;
    const auto report = reports(session, [&] { write(""); });
    followPort(
        session, {{"buffer", kSamplesQueued}},
        [&](const Json&, const Json& value) {
            const auto stamp = stampOf(stampIn(value));
            if (!stamp)
                throw Failure(Status::Refused, "samples of '" + session.word(0) +
                                                   "' have no time stamp that is known; name it with --field, as in "
                                                   "--field header.stamp");
            delays.add(now(*stamp < kMonotonic ? CLOCK_MONOTONIC : CLOCK_REALTIME) - *stamp);
            return true;
        },
        [&] {
            last = !report();
            return !last;
        },
        intervalOf(session));
    if (!last) write(session.json() ? "" : "in all: ");
}

}  // namespace oroforge::live_client
