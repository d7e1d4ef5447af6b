// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/shown_name.hpp>

#include <cctype>

namespace oroforge::model {

std::string cppShown(const std::string& type) {
    std::string result;
    for (std::size_t i = 0; i < type.size(); ++i) {
        const bool inName = i > 0 && (std::isalnum(static_cast<unsigned char>(type[i - 1])) != 0 || type[i - 1] == '_');
        if (!inName && type.compare(i, 2, "::") == 0)
            ++i;
        else
            result += type[i];
    }
    return result;
}

}  // namespace oroforge::model
