// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "canvas.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace oroforge::live_client {
namespace {

constexpr std::size_t kLabel = 10;  // letters of the range

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.5g", value);
    return text;
}

std::string atRight(const std::string& text, std::size_t width) {
    return (text.size() < width ? std::string(width - text.size(), ' ') : "") + text;
}

struct Range {
    double least = 0, greatest = 0;
    bool any = false;

    void add(double value) {
        least = any ? std::min(least, value) : value;
        greatest = any ? std::max(greatest, value) : value;
        any = true;
    }
    /** A constant is drawn in the middle. */
    void widen() {
        if (greatest - least > std::fabs(greatest) * 1e-12) return;
        const double half = greatest == 0 ? 1 : std::fabs(greatest) / 2;
        least -= half;
        greatest += half;
    }
    /** 0 to 1. Halves, because the range of the largest numbers is none. */
    double part(double value) const { return (value / 2 - least / 2) / (greatest / 2 - least / 2); }
};

}  // namespace

void Canvas::set(long x, long y) {
    if (x < 0 || y < 0 || x >= static_cast<long>(width()) || y >= static_cast<long>(height())) return;
    constexpr unsigned char kDots[4][2] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};  // of Unicode
    const auto column = static_cast<std::size_t>(x), fromTop = height() - 1 - static_cast<std::size_t>(y);
    dots_[fromTop / 4 * columns_ + column / 2] |= kDots[fromTop % 4][column % 2];
}

void Canvas::line(long x, long y, long toX, long toY) {
    const long steps = std::max({std::labs(toX - x), std::labs(toY - y), 1L});
    for (long i = 0; i <= steps; ++i) set(x + (toX - x) * i / steps, y + (toY - y) * i / steps);
}

std::vector<std::string> Canvas::rows() const {
    std::vector<std::string> rows;
    for (std::size_t row = 0; row != rows_; ++row) {
        std::string text;
        std::size_t end = 0;
        for (std::size_t column = 0; column != columns_; ++column) {
            const unsigned char dots = dots_[row * columns_ + column];
            if (!dots) {
                text += ' ';
                continue;
            }
            // U+2800 and up, as UTF-8.
            text += {'\xE2', static_cast<char>(0xA0 | dots >> 6), static_cast<char>(0x80 | (dots & 0x3F))};
            end = text.size();
        }
        rows.push_back(text.substr(0, end));
    }
    return rows;
}

std::vector<std::string> curve(const std::vector<Point>& points, double seconds, std::size_t columns,
                               std::size_t rows) {
    columns = std::max(columns, kLabel + 12);
    rows = std::max<std::size_t>(rows, 4);
    Range range;
    const double end = points.empty() ? 0 : points.back().time, begin = end - seconds;
    for (const Point& point : points)
        if (point.time >= begin && std::isfinite(point.value)) range.add(point.value);
    range.widen();
    Canvas canvas(columns - kLabel - 2, rows - 1);
    bool drawn = false;
    long lastX = 0, lastY = 0;
    for (const Point& point : points) {
        if (point.time < begin) continue;
        if (!std::isfinite(point.value)) {
            drawn = false;
            continue;
        }
        const auto x = std::lround((point.time - begin) / seconds * static_cast<double>(canvas.width() - 1));
        const auto y = std::lround(range.part(point.value) * static_cast<double>(canvas.height() - 1));
        canvas.line(drawn ? lastX : x, drawn ? lastY : y, x, y);
        drawn = true;
        lastX = x;
        lastY = y;
    }
    std::vector<std::string> lines;
    for (const std::string& row : canvas.rows()) {
        const bool top = lines.empty(), bottom = lines.size() + 2 == rows;
        const std::string label = !range.any ? "" : top ? number(range.greatest) : bottom ? number(range.least) : "";
        lines.push_back(atRight(label, kLabel) + (top ? " ┤" : bottom ? " ┤" : " │") + row);
    }
    const std::string left = "-" + number(seconds) + " s", right = "now";
    lines.push_back(std::string(kLabel + 2, ' ') + left + atRight(right, columns - kLabel - 2 - left.size()));
    return lines;
}

}  // namespace oroforge::live_client
