// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_TEXT_DEPTH_HPP
#define OROFORGE_LIVE_TEXT_DEPTH_HPP

#include <cstddef>
#include <string_view>

namespace OCL::live {

/** How deep the arrays and objects of a JSON text nest; of an invalid one, at least as deep as a parser would go. Code
    that works on JSON is recursive. */
std::size_t depthOf(std::string_view text);

}  // namespace OCL::live

#endif
