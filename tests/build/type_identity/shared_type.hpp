// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The type that two typekits register and a component uses.
#ifndef TESTS_BUILD_TYPE_IDENTITY_SHARED_TYPE_HPP
#define TESTS_BUILD_TYPE_IDENTITY_SHARED_TYPE_HPP

#include <vector>

namespace identity {

struct Sample {
    double value = 0;
    std::vector<double> history;
};

} // namespace identity

#endif
