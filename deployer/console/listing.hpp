// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The output of `ls`.
#ifndef OROFORGE_CONSOLE_LISTING_HPP
#define OROFORGE_CONSOLE_LISTING_HPP

#include "place.hpp"
#include "screen.hpp"

namespace OCL::console {

/** Lists everything that a component or service has, in tables; empty sections are left out. */
void list(Screen& screen, const NamedObject& target);

}  // namespace OCL::console

#endif
