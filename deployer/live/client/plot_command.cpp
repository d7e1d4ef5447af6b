// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// oro plot
#include "follow.hpp"

#include "canvas.hpp"
#include "failure.hpp"
#include "picture.hpp"
#include "value_text.hpp"

#include <algorithm>

namespace oroforge::live_client {
namespace {

constexpr std::chrono::milliseconds kBetweenPictures{100};
constexpr double kUsualSeconds = 10;
constexpr std::size_t kUsualRows = 16, kMostPoints = 200000;

class Plot {
public:
    explicit Plot(Session& session)
        : session_(session),
          seconds_(session.given().number("seconds", kUsualSeconds, 0.1, 86400)),
          rows_(static_cast<std::size_t>(session.given().number("height", kUsualRows, 4, 1000))),
          picture_(session.out()) {}

    void add(const Json& message, const Json& value) {
        const auto number = asNumber(value);
        if (!number)
            throw Failure(Status::Refused, "'" + session_.word(0) + "' is no number but " + valueText(value) +
                                               "; name one of its fields: 'oro echo --csv' lists them");
        const long long time = wholeOf(message, "time");
        if (points_.empty()) begin_ = time;
        points_.push_back({static_cast<double>(time - begin_) * 1e-9, *number});
        if (points_.size() < kMostPoints && points_.front().time >= points_.back().time - 2 * seconds_) return;
        // What has left the picture, and, of very many points, the older half.
        const double begin = points_.back().time - seconds_;
        const auto first =
            std::find_if(points_.begin(), points_.end(), [&](const Point& one) { return one.time >= begin; });
        points_.erase(
            points_.begin(),
            std::max(first, points_.size() < kMostPoints ? points_.begin() : points_.begin() + kMostPoints / 2));
    }
    void draw() {
        std::vector<std::string> lines{printable(session_.word(0)) + (points_.empty()
                                                                          ? "  no sample yet"
                                                                          : "  = " + valueText(points_.back().value))};
        for (std::string& line : curve(points_, seconds_, session_.out().width() - 1, rows_)) lines.push_back(line);
        picture_.draw(lines);
    }
    double seconds() const { return seconds_; }
    Json points() const {
        Json all = Json::array();
        for (const Point& point : points_) all.push_back({point.time, point.value});
        return all;
    }

private:
    Session& session_;
    const double seconds_;
    const std::size_t rows_;
    Picture picture_;
    std::vector<Point> points_;
    long long begin_ = 0;
};

}  // namespace

void plotPort(Session& session) {
    Plot plot(session);
    const bool live = session.out().isTerminal() && !session.json() && !session.given().has("once");
    const Deadline end =
        live ? kNever : deadlineIn(std::chrono::milliseconds(static_cast<long long>(plot.seconds() * 1000)));
    double left = session.given().number("count", 0, 1, 1e9);
    const bool counts = left > 0;
    followPort(
        session, {{"times", true}},
        [&](const Json& message, const Json& value) {
            plot.add(message, value);
            return !counts || --left > 0;
        },
        [&] {
            if (live) plot.draw();
            return Clock::now() < end;
        },
        kBetweenPictures);
    if (session.json())
        session.out().line(lineOf({{"points", plot.points()}}));
    else
        plot.draw();
}

}  // namespace oroforge::live_client
