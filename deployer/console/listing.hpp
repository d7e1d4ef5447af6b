// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What `ls` shows.
#ifndef OROFORGE_CONSOLE_LISTING_HPP
#define OROFORGE_CONSOLE_LISTING_HPP

#include "place.hpp"
#include "screen.hpp"

namespace OCL::console {

/** All that a component or service has, in tables; sections without content are left out. */
void list(Screen& screen, const Target& target);

}  // namespace OCL::console

#endif
