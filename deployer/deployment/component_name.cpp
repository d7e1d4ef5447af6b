// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "component_name.hpp"

#include <algorithm>

namespace OCL::deploy {
namespace {

bool isControl(char c) { return static_cast<unsigned char>(c) < 0x20U || c == '\x7f'; }

}  // namespace

std::string nameFault(const std::string& name) {
    if (std::any_of(name.begin(), name.end(), isControl))
        return "it has a control character, such as a line end or a tab";
    return name.find('/') == std::string::npos ? std::string() : "it has a '/'";
}

std::string printableName(const std::string& name) {
    std::string result = name;
    std::replace_if(result.begin(), result.end(), isControl, '?');
    return result;
}

}  // namespace OCL::deploy
