// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_DESCRIBED_GROWS_HPP
#define OROFORGE_TESTS_DESCRIBED_GROWS_HPP

#include <described/GrowsBase.hpp>
#include "Telling.hpp"

namespace described {

class Grows : public More<GrowsBase> {
public:
    using More::More;
};

}  // namespace described

#endif
