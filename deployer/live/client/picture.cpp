// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "picture.hpp"

#include <algorithm>

namespace oroforge::live_client {

void Picture::draw(const std::vector<std::string>& lines) {
    const bool terminal = out_.isTerminal();
    // One line is for the cursor.
    const std::size_t most = terminal ? std::max<std::size_t>(out_.height(), 2) - 1 : lines.size();
    const std::size_t count = std::min(lines.size(), most);
    // A window that became smaller has moved the rest out at its top.
    const std::size_t up = std::min(drawn_, most);
    std::string text = terminal && up ? "\033[" + std::to_string(up) + "A\r\033[J" : "";
    for (std::size_t i = 0; i != count; ++i) text += lines[i] + "\n";
    out_.write(text);
    drawn_ = count;
}

}  // namespace oroforge::live_client
