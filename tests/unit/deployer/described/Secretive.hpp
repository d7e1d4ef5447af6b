// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_DESCRIBED_SECRETIVE_HPP
#define OROFORGE_TESTS_DESCRIBED_SECRETIVE_HPP

#include <described/SecretiveBase.hpp>
#include "Telling.hpp"

namespace described {

class Secretive : public More<SecretiveBase> {
public:
    using More::More;
};

}  // namespace described

#endif
