// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The files that a generator makes, a row for each kind of file: names come from the table without rendering.
#ifndef OROFORGE_GENERATOR_RENDER_OUTPUT_TABLE_HPP
#define OROFORGE_GENERATOR_RENDER_OUTPUT_TABLE_HPP

#include <functional>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <render/renderer.hpp>

namespace oroforge::render {

enum class Owner {
    Generated,  ///< made again at each build
    Shared,     ///< written once; made again when forced
    User        ///< written once; never overwritten
};

struct OutputKind {
    std::string about;  ///< the kind of its subjects
    Owner owner;
    std::string path;  ///< "src/{class}.hpp": {class} is a word of the subject
    std::string templateName;
};

using OutputTable = std::vector<OutputKind>;

/// A component, a package, a typekit …: it has a file for each row of the table about its kind.
struct Subject {
    std::string kind;
    std::map<std::string, std::string> words;
    std::function<nlohmann::json()> view;  ///< called to render, but not for names
};

/// Returns names in the order of the subjects, then of the table.
std::vector<std::string> outputNames(const OutputTable& table, const std::vector<Subject>& subjects, Owner owner);

/// Path → text.
std::map<std::string, std::string> renderOutputs(const OutputTable& table, const std::vector<Subject>& subjects,
                                                 Owner owner, const Renderer& renderer);

}  // namespace oroforge::render

#endif
