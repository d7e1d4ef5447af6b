// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef T15_TWO_PROCESSES_SCAN_HPP
#define T15_TWO_PROCESSES_SCAN_HPP

#include <string>
#include <vector>

namespace laser {

struct Scan {
    std::string sensor;
    std::vector<double> distances;  // m
};

}  // namespace laser

#endif
