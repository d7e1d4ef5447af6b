// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef T14_QUEUES_SCAN_HPP
#define T14_QUEUES_SCAN_HPP

#include <string>
#include <vector>

namespace laser {

struct Scan {
    std::string sensor;
    std::vector<double> distances;  // m
};

}  // namespace laser

#endif
