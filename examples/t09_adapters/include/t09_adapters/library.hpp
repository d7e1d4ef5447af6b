// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A library as others write them: its data is private, and values begin undefined.
#pragma once
#include <cmath>

namespace library {

class Point {
public:
    Point() {}  // for speed
    Point(double x, double y) : data_{x, y} {}
    static Point origin() { return Point(0, 0); }
    static Point polar(double radius, double angle) {
        return Point(radius * std::cos(angle), radius * std::sin(angle));
    }
    double operator[](int index) const { return data_[index]; }
    double& operator[](int index) { return data_[index]; }

private:
    double data_[2];
};

class Path {
public:
    int length() const { return used_; }
    void setLength(int length) { used_ = length < 8 ? length : 8; }
    const Point& at(int index) const { return points_[index]; }
    Point& at(int index) { return points_[index]; }

private:
    Point points_[8];
    int used_ = 0;
};

}  // namespace library
