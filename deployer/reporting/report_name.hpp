// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_REPORT_NAME_HPP
#define OROFORGE_REPORT_NAME_HPP

#include <algorithm>
#include <string>

namespace OCL::reporting {

/** True for a name with control characters, which would begin a line in a report or move the cursor of a terminal. */
inline bool hasControl(const std::string& name) {
    return std::any_of(name.begin(), name.end(),
                       [](char c) { return static_cast<unsigned char>(c) < 0x20U || c == '\x7f'; });
}

}  // namespace OCL::reporting

#endif
