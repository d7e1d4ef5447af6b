// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What every generated source that describes types begins with. Not for other files: warnings are off below it.
#ifndef ORO_TYPEKIT_SOURCE_HPP
#define ORO_TYPEKIT_SOURCE_HPP

// The headers of the runtime need not bring all that components use.
#define ORO_TYPEKIT_SOURCE

// Instances are declared as visible also where the package hides its symbols.
#pragma GCC diagnostic ignored "-Wattributes"
// Offsets are needed of all structs; those that are not of standard layout have them too in GCC and clang.
#pragma GCC diagnostic ignored "-Winvalid-offsetof"
// Fields that users should no longer use are there all the same.
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
#ifndef __clang__
// Default values are copied here; that a constructor leaves fields unset is for its author to decide.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <cstring>
#include <type_traits>
#include <utility>

#include "GeneratedTypekit.hpp"
#include "TypekitUser.hpp"

#endif
