// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/typekit_files.hpp>

#include <algorithm>
#include <initializer_list>
#include <sstream>

#include <nlohmann/json.hpp>

#include <plan/sources.hpp>
#include <render/output_table.hpp>

namespace oroforge::typekit {

namespace {

using nlohmann::json;
using render::Owner;

/// Removes empty lines that omitted sections leave: after "{", before "}", and all but one of several.
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

/// A template reads only parts of the view, and rendering copies what it gets.
json without(const json& view, std::initializer_list<const char*> keys) {
    json result = json::object();
    for (const auto& [key, value] : view.items())
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) result[key] = value;
    return result;
}

const render::OutputTable kOutputs = {
    {"plugin", Owner::Generated, "Plugin.cpp", "typekit/Plugin.cpp"},
    {"source", Owner::Generated, "types_{word}.cpp", "typekit/types.cpp"},
    {"header", Owner::Generated, "{header}", "typekit/Types.hpp"},
};

json pluginView(const json& typekit) {
    json view = without(typekit, {"sources", "externs", "makers", "schemas"});
    for (const json& source : typekit["sources"])
        if (source.contains("used")) view["sources"].push_back({{"word", source["word"]}});
    return view;
}

json sourceView(const json& typekit, std::size_t source) {
    json view = typekit["sources"][source];
    for (const char* key : {"versionGuard", "identifier"}) view[key] = typekit[key];
    return view;
}

void addSources(std::vector<render::Subject>& all, const std::vector<std::string>& words, const json& view) {
    for (std::size_t i = 0; i != words.size(); ++i)
        all.push_back({"source", {{"word", words[i]}}, [&view, i] { return sourceView(view, i); }});
}

/// The view may be empty if only names are needed.
std::vector<render::Subject> subjectsOf(const std::string& typekit, const std::vector<std::string>& words,
                                        const json& view) {
    std::vector<render::Subject> all = {{"plugin", {}, [&] { return pluginView(view); }}};
    addSources(all, words, view);
    all.push_back({"header", {{"header", userHeaderName(typekit)}}, [&] { return without(view, {"sources"}); }});
    return all;
}

}  // namespace

std::string userHeaderName(const std::string& typekit) { return "types/" + typekit + "/typekit/Types.hpp"; }

std::vector<std::string> outputNames(const std::string& typekit, const std::vector<model::Header>& headers) {
    std::vector<std::string> words;
    for (const Source& source : sourcesOf(headers)) words.push_back(source.word);
    return render::outputNames(kOutputs, subjectsOf(typekit, words, {}), Owner::Generated);
}

namespace {

std::vector<std::string> wordsOf(const json& view) {
    std::vector<std::string> words;
    for (const json& source : view["sources"]) words.push_back(source["word"]);
    return words;
}

emit::Outputs rendered(const std::vector<render::Subject>& subjects, const render::Renderer& renderer) {
    auto outputs = render::renderOutputs(kOutputs, subjects, Owner::Generated, renderer);
    for (auto& [name, text] : outputs) text = tidied(text);
    return outputs;
}

}  // namespace

emit::Outputs renderTypekit(const json& view, const render::Renderer& renderer) {
    return rendered(subjectsOf(view["name"], wordsOf(view), view), renderer);
}

emit::Outputs renderSources(const json& view, const render::Renderer& renderer) {
    std::vector<render::Subject> subjects;
    addSources(subjects, wordsOf(view), view);
    return rendered(subjects, renderer);
}

std::string sourceName(const std::string& word) { return "types_" + word + ".cpp"; }

}  // namespace oroforge::typekit
