// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "statistics.hpp"

#include <algorithm>
#include <cmath>

namespace oroforge::live_client {

void Statistics::add(double value) {
    least_ = count_ ? std::min(least_, value) : value;
    greatest_ = count_ ? std::max(greatest_, value) : value;
    ++count_;
    const double before = value - mean_;
    mean_ += before / static_cast<double>(count_);
    squares_ += before * (value - mean_);
}

double Statistics::deviation() const { return count_ > 1 ? std::sqrt(squares_ / static_cast<double>(count_ - 1)) : 0; }

}  // namespace oroforge::live_client
