// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The output of `ls`.
#ifndef OROFORGE_CONSOLE_LISTING_HPP
#define OROFORGE_CONSOLE_LISTING_HPP

#include "place.hpp"
#include "screen.hpp"
#include "visits.hpp"

#include <vector>

namespace OCL::console {

/** Lists everything that a component or service has, in tables; empty sections are left out. Last samples of
    input ports are those of output ports of `around` and their peers, see KnownPorts. */
void list(Screen& screen, const NamedObject& target, const std::vector<Gate>& around);

}  // namespace OCL::console

#endif
