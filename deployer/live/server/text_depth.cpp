// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "text_depth.hpp"

#include <algorithm>

namespace OCL::live {

std::size_t depthOf(std::string_view text) {
    std::size_t depth = 0, deepest = 0;
    bool quoted = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char letter = text[at];
        if (quoted && letter == '\\') {
            ++at;
        } else if (letter == '"') {
            quoted = !quoted;
        } else if (!quoted && (letter == '[' || letter == '{')) {
            deepest = std::max(deepest, ++depth);
        } else if (!quoted && (letter == ']' || letter == '}') && depth != 0) {
            --depth;
        }
    }
    return deepest;
}

}  // namespace OCL::live
