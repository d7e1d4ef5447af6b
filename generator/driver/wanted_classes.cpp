// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <driver/wanted_classes.hpp>

#include <sstream>

#include <nlohmann/json.hpp>

#include <merge/plan.hpp>

namespace oroforge::driver {

std::vector<merge::WantedClass> wantedClasses(const model::Package& package, const render::Renderer& renderer) {
    return merge::wantedClasses(package, [&](const std::string& hook) {
        std::istringstream text(renderer.render("partials/hooks/" + hook, nlohmann::json::object()));
        std::vector<std::string> lines;
        // The template is indented as in a function.
        for (std::string line; std::getline(text, line);)
            lines.push_back(line.compare(0, 4, "    ") == 0 ? line.substr(4) : line);
        return lines;
    });
}

std::string firstRecord(const model::Package& package, const render::Renderer& renderer) {
    merge::Record record;
    for (const merge::WantedClass& wanted : wantedClasses(package, renderer))
        record[wanted.name] = merge::recordOf(wanted);
    return record.empty() ? std::string() : merge::toText(record);
}

}  // namespace oroforge::driver
