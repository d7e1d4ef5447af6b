// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Types as a user writes them, and their tables as typegen writes those.
#ifndef TESTS_UNIT_TYPES_SAMPLE_TYPES_HPP
#define TESTS_UNIT_TYPES_SAMPLE_TYPES_HPP

#include <rtt/types/GeneratedTypekit.hpp>
#include <rtt/types/Types.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sample {

enum class Mode : std::uint8_t { Idle, Filling, Draining = 7 };

struct Point {
    double x = 0, y = 0;
};

struct Tank {
    int id = 0;
    std::string label;
    Point position;
    std::vector<double> levels;
    std::vector<Point> path;
    double weights[3] = {0, 0, 0};
    std::array<int, 2> pair{};
    Mode mode = Mode::Idle;
    std::uint8_t small = 0;
    std::vector<bool> flags;
};

namespace t = RTT::types;

inline constexpr t::Member pointMembers[] = {
    {"x", offsetof(Point, x), &t::typeRef<double>, 0, "east", "m"},
    {"y", offsetof(Point, y), &t::typeRef<double>, 0, "north", "m"},
};
inline constexpr t::Member tankMembers[] = {
    {"id", offsetof(Tank, id), &t::typeRef<int>, 0, "", ""},
    {"label", offsetof(Tank, label), &t::typeRef<std::string>, 0, "", ""},
    {"position", offsetof(Tank, position), &t::typeRef<Point>, 0, "", ""},
    {"levels", offsetof(Tank, levels), &t::typeRef<std::vector<double>>, 0, "", ""},
    {"path", offsetof(Tank, path), &t::typeRef<std::vector<Point>>, 0, "", ""},
    {"weights", offsetof(Tank, weights), &t::typeRef<double>, 3, "", ""},
    {"pair", offsetof(Tank, pair), &t::typeRef<int>, 2, "", ""},
    {"mode", offsetof(Tank, mode), &t::typeRef<Mode>, 0, "", ""},
    {"small", offsetof(Tank, small), &t::typeRef<std::uint8_t>, 0, "", ""},
    {"flags", offsetof(Tank, flags), &t::typeRef<std::vector<bool>>, 0, "", ""},
};
inline constexpr t::Enumerator modes[] = {
    {"Idle", 0, ""}, {"Filling", 1, ""}, {"Draining", 7, ""}, {"Emptying", 7, ""}};

/** Registers all of them; once per process is enough, more do no harm. */
inline void addTypes() {
    const auto types = t::Types();
    types->addType(t::makeStructType<Point>("/sample/Point", pointMembers, 2));
    types->addType(t::makeStructType<Tank>("/sample/Tank", tankMembers, 10, "a tank"));
    types->addType(t::makeEnumType<Mode>("/sample/Mode", modes, 4));
    types->addType(t::makeSequenceType<std::vector<double>>("/std/vector</double>"));
    types->addType(t::makeSequenceType<std::vector<Point>>("/std/vector</sample/Point>"));
    types->addType(t::makeSequenceType<std::vector<bool>>("/std/vector</bool>"));
    types->addType(t::makeArrayType<double>("/double[]"));
    types->addType(t::makeArrayType<int>("/int[]"));
}

}  // namespace sample

#endif
