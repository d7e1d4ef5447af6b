// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef GAINS_HPP
#define GAINS_HPP

#include <vector>

namespace control {

/** Of a PID controller. */
struct Gains {
    double p = 0, i = 0, d = 0;
    std::vector<double> limits;
};

}  // namespace control

#endif
