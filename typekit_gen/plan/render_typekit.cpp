// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/render_typekit.hpp>

#include <algorithm>
#include <initializer_list>
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

/// A file reads only parts of the view, and copies what it is given.
nlohmann::json without(const nlohmann::json& view, std::initializer_list<const char*> keys) {
    nlohmann::json result = nlohmann::json::object();
    for (const auto& [key, value] : view.items())
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) result[key] = value;
    return result;
}

}  // namespace

emit::Outputs renderTypekit(const nlohmann::json& view, const render::Renderer& renderer) {
    emit::Outputs outputs;
    outputs[userHeaderName(view["name"])] = tidied(renderer.render("typekit/Types.hpp", without(view, {"buckets"})));
    nlohmann::json pluginView = without(view, {"buckets", "externs", "makers", "schemas"});
    for (const nlohmann::json& bucket : view["buckets"])
        if (bucket.contains("used")) pluginView["buckets"].push_back({{"index", bucket["index"]}});
    outputs[pluginFileName()] = tidied(renderer.render("typekit/Plugin.cpp", pluginView));
    for (const nlohmann::json& bucket : view["buckets"]) {
        nlohmann::json fileView = bucket;
        for (const char* key : {"versionGuard", "identifier"}) fileView[key] = view[key];
        outputs[bucketFileName(bucket["index"])] = tidied(renderer.render("typekit/types.cpp", fileView));
    }
    return outputs;
}

}  // namespace oroforge::typekit
