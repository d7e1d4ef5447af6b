// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The types of downstream_transport.cpp.
#ifndef OROFORGE_TESTS_DOWNSTREAM_TYPES_HPP
#define OROFORGE_TESTS_DOWNSTREAM_TYPES_HPP

namespace downstream {

struct Spot {
    double east = 0, north = 0;
};

struct Corner {
    double x = 0, y = 0;
};

}  // namespace downstream

#endif
