// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <model/doc_text.hpp>

#include <algorithm>
#include <sstream>

namespace oroforge::model {

namespace {

std::string trimmed(const std::string& text) {
    const char* blanks = " \t\r\n";
    const auto begin = text.find_first_not_of(blanks);
    return begin == std::string::npos ? std::string() : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

}  // namespace

std::vector<std::string> commentLines(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(trimmed(text));
    for (std::string line; std::getline(in, line);) {
        line = trimmed(line);
        // Compilers treat a CR as the end of a line, so it would end the comment.
        line.erase(std::remove(line.begin(), line.end(), '\r'), line.end());
        // A backslash at the end would continue the comment on the next line of code.
        if (!line.empty() && line.back() == '\\') line += " .";
        lines.push_back(line);
    }
    return lines;
}

std::string oneLine(const std::string& text) {
    std::string result;
    for (const std::string& line : commentLines(text)) result += (result.empty() ? "" : " ") + line;
    return result;
}

std::string docWithUnit(const std::string& doc, const std::string& unit) {
    if (unit.empty()) return oneLine(doc);
    return doc.empty() ? "[" + unit + "]" : oneLine(doc) + " [" + unit + "]";
}

}  // namespace oroforge::model
