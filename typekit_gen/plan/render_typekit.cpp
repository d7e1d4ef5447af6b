// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/render_typekit.hpp>

#include <sstream>

#include <nlohmann/json.hpp>

#include <plan/output_names.hpp>

namespace oroforge::typekit {

namespace {

/// Sections that are left out leave empty lines behind: none after "{" or before "}", never two in a row.
std::string tidied(const std::string& text) {
    std::string result, line, last = "{";
    bool blank = false;
    std::istringstream lines(text);
    while (std::getline(lines, line)) {
        if (line.empty()) {
            blank = true;
            continue;
        }
        const bool closing = line.find_first_not_of(' ') == line.find('}');
        const bool opened = last.back() == '{' && last.compare(0, 9, "namespace") != 0;
        if (blank && !opened && !(closing && line.find("namespace") == std::string::npos)) result += "\n";
        result += line + "\n";
        last = line;
        blank = false;
    }
    return result;
}

}  // namespace

emit::Outputs renderTypekit(const nlohmann::json& view, const render::Renderer& renderer) {
    emit::Outputs outputs;
    nlohmann::json headerView = view;
    headerView["keyword"] = "extern template";
    headerView["visible"] = "RTT_EXPORT ";
    outputs[userHeaderName(view["name"])] = tidied(renderer.render("typekit/Types.hpp", headerView));
    outputs[pluginFileName()] = tidied(renderer.render("typekit/Plugin.cpp", view));
    for (const nlohmann::json& bucket : view["buckets"]) {
        nlohmann::json fileView = bucket;
        for (const char* key : {"banner", "versionGuard", "userHeader", "identifier"}) fileView[key] = view[key];
        fileView["keyword"] = "template";
        fileView["visible"] = "";
        outputs[bucketFileName(bucket["index"])] = tidied(renderer.render("typekit/types.cpp", fileView));
    }
    return outputs;
}

}  // namespace oroforge::typekit
