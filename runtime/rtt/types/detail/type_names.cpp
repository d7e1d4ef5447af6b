// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "type_names.hpp"

namespace RTT::types::detail {

std::string dottedName(const std::string& name) {
    std::string result;
    for (const char c : name) {
        if (c != '/')
            result += c;
        else if (!result.empty() && result.back() != '<')
            result += '.';
    }
    return result;
}

std::string slashedName(const std::string& name) {
    std::string result = "/";
    for (const char c : name) {
        if (c == '.')
            result += '/';
        else if (c == '<')
            result += "</";
        else
            result += c;
    }
    return result;
}

}  // namespace RTT::types::detail
