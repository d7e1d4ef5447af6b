// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_TYPEKITS_CLIMATE_HPP
#define OROFORGE_TESTS_TYPEKITS_CLIMATE_HPP

namespace greenhouse {

struct Climate {
    double temperature = 0;
};

/** No typekit has it. */
struct Private {
    int value = 0;
};

}  // namespace greenhouse

#endif
