// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_DESCRIBED_SINK_HPP
#define OROFORGE_TESTS_DESCRIBED_SINK_HPP

#include <described/SinkBase.hpp>
#include "Telling.hpp"

namespace described {

class Sink : public Telling<SinkBase> {
public:
    using Telling::Telling;
};

}  // namespace described

#endif
