// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "interface_lines.hpp"

#include <map>

namespace oroforge::test {

namespace {

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
}

/// ", std::allocator<double>" and the like, with what is in their brackets.
void dropArgument(std::string& text, const std::string& name) {
    for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos;) {
        std::size_t end = at + name.size();
        for (int depth = 1; depth != 0 && end < text.size(); ++end)
            depth += text[end] == '<' ? 1 : text[end] == '>' ? -1 : 0;
        text.erase(at, end - at);
    }
}

}  // namespace

std::string commonSpelling(std::string type) {
    replaceAll(type, "(anonymous namespace)::", "");
    replaceAll(type, "::__cxx11", "");
    replaceAll(type, "std::basic_string<char, std::char_traits<char>, std::allocator<char> >", "std::string");
    dropArgument(type, ", std::allocator<");
    replaceAll(type, " >", ">");
    if (const std::size_t end = type.size(); end > 7 && type.compare(end - 7, 7, " const&") == 0)
        type = "const " + type.substr(0, end - 7) + "&";
    static const std::map<std::string, std::string> same = {{"odd::Samples", "std::vector<double>"},  // an alias
                                                            {"std::uint8_t", "unsigned char"},
                                                            {"std::uint64_t", "unsigned long"},
                                                            {"std::int64_t", "long"},
                                                            {"std::uint32_t", "unsigned int"},
                                                            {"std::int8_t", "signed char"},
                                                            {"std::uint16_t", "unsigned short"}};
    const auto found = same.find(type);
    return found == same.end() ? type : found->second;
}

}  // namespace oroforge::test
