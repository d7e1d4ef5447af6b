// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "theme.hpp"

namespace OCL::console {
namespace {

const char* sequenceOf(Style style, bool dark) {
    switch (style) {
        case Style::Title: return "\033[1m";
        case Style::Name: return dark ? "\033[1;36m" : "\033[34m";
        case Style::Type: return dark ? "\033[32m" : "\033[32m";
        case Style::Value: return dark ? "\033[1;33m" : "\033[35m";
        case Style::Faint: return dark ? "\033[37m" : "\033[90m";
        case Style::Good: return "\033[32m";
        case Style::Bad: return "\033[1;31m";
        case Style::Plain: break;
    }
    return nullptr;
}

}  // namespace

std::string Theme::paint(Style style, const std::string& text) const {
    const char* const sequence = kind_ == NoColors || text.empty() ? nullptr : sequenceOf(style, kind_ == Dark);
    return sequence ? sequence + text + "\033[0m" : text;
}

}  // namespace OCL::console
