// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A curve drawn with letters.
#ifndef OROFORGE_LIVE_CLIENT_CANVAS_HPP
#define OROFORGE_LIVE_CLIENT_CANVAS_HPP

#include <cstddef>
#include <string>
#include <vector>

namespace oroforge::live_client {

/** A picture of dots; each letter of it is a braille pattern of 2 x 4 dots. */
class Canvas {
public:
    Canvas(std::size_t columns, std::size_t rows) : columns_(columns), rows_(rows), dots_(columns * rows, 0) {}

    std::size_t width() const { return columns_ * 2; }
    std::size_t height() const { return rows_ * 4; }
    /** Sets a dot; (0, 0) is at the bottom left. Dots outside are left out. */
    void set(long x, long y);
    /** Sets the dots of a line between two others. */
    void line(long x, long y, long toX, long toY);
    /** The rows from top to bottom, without blanks at their ends. */
    std::vector<std::string> rows() const;

private:
    const std::size_t columns_, rows_;
    std::vector<unsigned char> dots_;  // eight per letter
};

/** A point of a curve: seconds and value. */
struct Point {
    double time = 0, value = 0;
};

/** A curve of `seconds` up to the last point, with its range at the left and its times below, in so many letters and
    lines. Values that are no finite numbers leave a gap. */
std::vector<std::string> curve(const std::vector<Point>& points, double seconds, std::size_t columns, std::size_t rows);

}  // namespace oroforge::live_client

#endif
