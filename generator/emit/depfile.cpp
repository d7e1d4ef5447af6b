// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <emit/depfile.hpp>

#include <emit/outputs.hpp>

namespace oroforge::emit {

namespace {

std::string escaped(const std::string& path) {
    std::string result;
    for (const char c : path) {
        if (c == '$') result += '$';
        if (c == ' ' || c == '#' || c == '\\') result += '\\';
        result += c;
    }
    return result;
}

}  // namespace

std::string depfileText(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
    std::string text;
    for (const std::string& output : outputs) text += (text.empty() ? "" : " ") + escaped(output);
    text += ":";
    for (const std::string& input : inputs) text += " \\\n  " + escaped(input);
    return text + "\n";
}

bool writeDepfile(const std::filesystem::path& file, const std::vector<std::string>& outputs,
                  const std::vector<std::string>& inputs, diag::Sink& sink) {
    return write({{file.filename().string(), depfileText(outputs, inputs)}}, file.parent_path(), sink);
}

}  // namespace oroforge::emit
