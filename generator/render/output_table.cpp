// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <render/output_table.hpp>

#include <nlohmann/json.hpp>

namespace oroforge::render {

namespace {

std::string pathOf(const std::string& pattern, const Subject& subject) {
    std::string path;
    std::size_t at = 0;
    for (std::size_t open; (open = pattern.find('{', at)) != std::string::npos;) {
        const std::size_t close = pattern.find('}', open);
        path += pattern.substr(at, open - at) + subject.words.at(pattern.substr(open + 1, close - open - 1));
        at = close + 1;
    }
    return path + pattern.substr(at);
}

std::vector<const OutputKind*> kindsOf(const OutputTable& table, const Subject& subject, Owner owner) {
    std::vector<const OutputKind*> kinds;
    for (const OutputKind& kind : table)
        if (kind.about == subject.kind && kind.owner == owner) kinds.push_back(&kind);
    return kinds;
}

}  // namespace

std::vector<std::string> outputNames(const OutputTable& table, const std::vector<Subject>& subjects, Owner owner) {
    std::vector<std::string> names;
    for (const Subject& subject : subjects)
        for (const OutputKind* kind : kindsOf(table, subject, owner)) names.push_back(pathOf(kind->path, subject));
    return names;
}

std::map<std::string, std::string> renderOutputs(const OutputTable& table, const std::vector<Subject>& subjects,
                                                 Owner owner, const Renderer& renderer) {
    std::map<std::string, std::string> texts;
    for (const Subject& subject : subjects) {
        const auto kinds = kindsOf(table, subject, owner);
        const nlohmann::json view = kinds.empty() ? nlohmann::json() : subject.view();
        for (const OutputKind* kind : kinds)
            texts[pathOf(kind->path, subject)] = renderer.render(kind->templateName, view);
    }
    return texts;
}

}  // namespace oroforge::render
