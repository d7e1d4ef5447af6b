// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/source_file.hpp>

#include <algorithm>

namespace RTT::scripting::detail {

// A comment in the last line of the previous item belongs to that.
SourceFile::Excerpt SourceFile::withComment(const ast::Item& item) const {
    std::size_t begin = 0;
    if (&item != tree.items.data()) {
        const ast::Item& before = *(&item - 1);
        begin = std::min(text.find('\n', before.begin + before.size), item.begin);
    }
    begin = std::min(text.find_first_not_of(" \t\r\n", begin), item.begin);
    const auto first = text.begin() + static_cast<std::string::difference_type>(begin);
    const auto line = std::count(text.begin(), first, '\n');
    const std::size_t newline = begin == 0 ? std::string::npos : text.rfind('\n', begin - 1);
    const std::size_t column = newline == std::string::npos ? begin : begin - newline - 1;
    return {text.substr(begin, item.begin + item.size - begin),
            {static_cast<unsigned>(line) + 1, static_cast<unsigned>(column) + 1}};
}

}  // namespace RTT::scripting::detail
