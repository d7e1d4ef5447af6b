// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_SCHEMA_LIMITS_HPP
#define OROFORGE_SCHEMA_LIMITS_HPP

#include <cstddef>

namespace oroforge::schema {

/** Arrays of schemas have at most so many elements, as messages do. */
constexpr std::size_t kLongest = std::size_t(1) << 30;
/** Structs, modules and parentheses nest so deeply at most. */
constexpr std::size_t kDeepest = 100;
/** Lists of lists of one field. */
constexpr std::size_t kMostLists = 16;
/** Fields of all structs, those of base structs included. */
constexpr std::size_t kMostFields = 100000;

}  // namespace oroforge::schema

#endif
