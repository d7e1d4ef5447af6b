// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/typekit_files.hpp>

#include <algorithm>
#include <initializer_list>
#include <sstream>

#include <nlohmann/json.hpp>

#include <plan/buckets.hpp>
#include <render/output_table.hpp>

namespace oroforge::typekit {

namespace {

using nlohmann::json;
using render::Owner;

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
json without(const json& view, std::initializer_list<const char*> keys) {
    json result = json::object();
    for (const auto& [key, value] : view.items())
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) result[key] = value;
    return result;
}

/// Every file of a typekit.
const render::OutputTable kOutputs = {
    {"plugin", Owner::Generated, "Plugin.cpp", "typekit/Plugin.cpp"},
    {"bucket", Owner::Generated, "types_{bucket}.cpp", "typekit/types.cpp"},
    {"header", Owner::Generated, "{header}", "typekit/Types.hpp"},
};

json pluginView(const json& typekit) {
    json view = without(typekit, {"buckets", "externs", "makers", "schemas"});
    for (const json& bucket : typekit["buckets"])
        if (bucket.contains("used")) view["buckets"].push_back({{"index", bucket["index"]}});
    return view;
}

json bucketView(const json& typekit, std::size_t bucket) {
    json view = typekit["buckets"][bucket];
    for (const char* key : {"versionGuard", "identifier"}) view[key] = typekit[key];
    return view;
}

/// For names, the view may be empty.
std::vector<render::Subject> subjectsOf(const std::string& typekit, const json& view) {
    std::vector<render::Subject> all = {{"plugin", {}, [&] { return pluginView(view); }}};
    for (std::size_t bucket = 0; bucket < kBuckets; ++bucket)
        all.push_back(
            {"bucket", {{"bucket", std::to_string(bucket)}}, [&view, bucket] { return bucketView(view, bucket); }});
    all.push_back({"header", {{"header", userHeaderName(typekit)}}, [&] { return without(view, {"buckets"}); }});
    return all;
}

}  // namespace

std::string userHeaderName(const std::string& typekit) { return "types/" + typekit + "/typekit/Types.hpp"; }

std::vector<std::string> outputNames(const std::string& typekit) {
    return render::outputNames(kOutputs, subjectsOf(typekit, {}), Owner::Generated);
}

emit::Outputs renderTypekit(const json& view, const render::Renderer& renderer) {
    auto outputs = render::renderOutputs(kOutputs, subjectsOf(view["name"], view), Owner::Generated, renderer);
    for (auto& [name, text] : outputs) text = tidied(text);
    return outputs;
}

}  // namespace oroforge::typekit
