// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <diag/diagnostic.hpp>

#include <tuple>

namespace oroforge::diag {

bool operator==(const Location& a, const Location& b) {
    return std::tie(a.file, a.line, a.column) == std::tie(b.file, b.line, b.column);
}

bool operator<(const Location& a, const Location& b) {
    return std::tie(a.file, a.line, a.column) < std::tie(b.file, b.line, b.column);
}

bool operator==(const Fix& a, const Fix& b) {
    return a.begin == b.begin && a.end == b.end && a.replacement == b.replacement;
}

}  // namespace oroforge::diag
