// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// One header in several versions, as it would be edited over the years.
#pragma once

#include <utility>
#include <vector>

namespace plan {

#ifdef VERSION_RENUMBERED
enum class Mode { Moving, Idle };
#elif defined VERSION_MORE_MODES
enum class Mode { Idle, Moving, Waiting };
#else
enum class Mode { Idle, Moving };
#endif

struct Place {
#ifdef VERSION_SWAPPED
    double y = 0, x = 0;
#elif defined VERSION_RENAMED
    double x = 0, z = 0;
#elif defined VERSION_RETYPED
    double x = 0;
    long long y = 0;
#elif defined VERSION_UNITS
    double x = 0;  ///< @unit mm
    double y = 0;
#else
    double x = 0;  ///< from the door, @unit m
    double y = 0;
#endif
};

struct Sample {
    int count = 0;
    Mode mode = Mode::Idle;
    std::vector<std::pair<int, Place>> path;
#ifdef VERSION_LARGER
    double added = 0;
#endif
};

}  // namespace plan
