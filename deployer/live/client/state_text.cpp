// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "state_text.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace oroforge::live_client {

std::string stateSummary(const Json& components) {
    std::vector<std::pair<std::string, std::size_t>> counts;
    for (const Json& component : components) {
        const std::string state = printable(textOf(component, "state"));
        const auto found =
            std::find_if(counts.begin(), counts.end(), [&](const auto& one) { return one.first == state; });
        if (found == counts.end())
            counts.emplace_back(state, 1);
        else
            ++found->second;
    }
    std::string text;
    for (const auto& [state, count] : counts) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + state;
    return text;
}

Style styleOfState(const std::string& state) {
    if (state == "Running") return Style::Good;
    const bool wrong = state.find("rror") != std::string::npos || state == "Exception";
    return wrong ? Style::Bad : Style::Plain;
}

}  // namespace oroforge::live_client
