// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <render/templates.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace fs = std::filesystem;

namespace oroforge::render {

namespace {

const std::string kSuffix = ".mustache";

std::string withoutLeadingComment(const std::string& text) {
    if (text.compare(0, 3, "{{!") != 0) return text;
    const auto end = text.find("}}");
    if (end == std::string::npos) return text;
    const auto next = end + 2;
    return text.substr(next < text.size() && text[next] == '\n' ? next + 1 : next);
}

}  // namespace

Templates::Templates(const diag::EmbeddedFiles& files) { add(files); }

void Templates::add(const std::string& name, const std::string& text) { texts_[name] = withoutLeadingComment(text); }

void Templates::add(const diag::EmbeddedFiles& files) {
    for (const diag::EmbeddedFile& file : files) add(std::string(file.name), std::string(file.text));
}

bool Templates::overrideFrom(const std::string& directory, diag::Sink& sink) {
    std::error_code error;
    if (!fs::is_directory(directory, error)) {
        sink.error({directory, 0, 0}, "EMIT003", "not a directory; expected a directory of *.mustache templates");
        return false;
    }
    for (const auto& entry : fs::recursive_directory_iterator(directory)) {
        if (entry.path().extension() != kSuffix) continue;
        std::ifstream in(entry.path(), std::ios::binary);
        std::ostringstream text;
        text << in.rdbuf();
        if (!in) {
            sink.error({entry.path().string(), 0, 0}, "EMIT003", "cannot read the template");
            return false;
        }
        std::string name = entry.path().lexically_relative(directory).generic_string();
        name.resize(name.size() - kSuffix.size());
        add(name, text.str());
    }
    return true;
}

const std::string* Templates::find(const std::string& name) const {
    const auto found = texts_.find(name);
    return found == texts_.end() ? nullptr : &found->second;
}

std::vector<std::string> Templates::names() const {
    std::vector<std::string> result;
    for (const auto& entry : texts_) result.push_back(entry.first);
    return result;
}

}  // namespace oroforge::render
