// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_DESCRIBED_SOURCE_HPP
#define OROFORGE_TESTS_DESCRIBED_SOURCE_HPP

#include <described/SourceBase.hpp>
#include "Telling.hpp"

namespace described {

class Source : public Telling<SourceBase> {
public:
    using Telling::Telling;
};

}  // namespace described

#endif
