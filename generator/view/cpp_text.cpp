// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <view/cpp_text.hpp>

#include <cctype>
#include <set>
#include <sstream>

#include <model/cpp_type.hpp>

namespace oroforge::view {

namespace {

std::string trimmed(const std::string& text) {
    const char* blanks = " \t\r\n";
    const auto begin = text.find_first_not_of(blanks);
    return begin == std::string::npos ? std::string() : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string withSuffix(const std::string& number, model::TypeClass kind) {
    // C++ has no literals with a plus sign in every context; it adds nothing.
    std::string text = number.front() == '+' ? number.substr(1) : number;
    if (kind == model::TypeClass::Unsigned) return text + "U";
    if (kind == model::TypeClass::Signed) return text;
    if (text.find_first_of(".eE") == std::string::npos) text += ".0";
    return kind == model::TypeClass::Float ? text + "F" : text;
}

bool containsWord(const std::string& text, const std::string& word) {
    const auto isLetter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !isLetter(text[at - 1])) && (end == text.size() || !isLetter(text[end]))) return true;
    }
    return false;
}

}  // namespace

std::string stringLiteral(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        switch (c) {
            case '"': result += "\\\""; break;
            case '\\': result += "\\\\"; break;
            case '\n': result += "\\n"; break;
            case '\t': result += "\\t"; break;
            case '\r': break;
            default: result += c;
        }
    }
    return result + "\"";
}

std::vector<std::string> commentLines(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(trimmed(text));
    for (std::string line; std::getline(in, line);) {
        line = trimmed(line);
        // A backslash at the end would draw the next line of code into the comment.
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

std::string valueLiteral(const std::string& text, const std::string& type) {
    const model::TypeClass kind = model::classify(type);
    if (kind == model::TypeClass::String) return stringLiteral(text);
    if (kind == model::TypeClass::Character) {
        const std::string escaped = text == "'" ? "\\'" : text == "\\" ? "\\\\" : text;
        return "'" + escaped + "'";
    }
    return model::isNumber(kind) ? withSuffix(text, kind) : text;
}

std::string includeName(const std::string& header, const std::string& package) {
    const std::string folder = "/include/";
    const std::string path = "/" + header;
    const std::size_t at = path.rfind(folder);
    if (at != std::string::npos) {
        const std::string name = path.substr(at + folder.size());
        if (name.find('/') != std::string::npos) return name;
    }
    const std::size_t fileAt = path.rfind('/');
    const std::string file = path.substr(fileAt + 1);
    const std::string above = path.substr(0, fileAt);
    const std::string parent = above.substr(above.rfind('/') + 1);
    const bool named = !above.empty() && parent != "include" && parent != package;
    return package + "/" + (named ? parent + "/" : "") + file;
}

std::vector<std::string> standardHeaders(const std::vector<std::string>& types) {
    static const std::pair<const char*, const char*> known[] = {
        {"std::array", "array"},       {"std::deque", "deque"},     {"std::list", "list"},   {"std::map", "map"},
        {"std::optional", "optional"}, {"std::pair", "utility"},    {"std::set", "set"},     {"std::string", "string"},
        {"std::vector", "vector"},     {"std::complex", "complex"}, {"size_t", "cstddef"},   {"int8_t", "cstdint"},
        {"uint8_t", "cstdint"},        {"int16_t", "cstdint"},      {"uint16_t", "cstdint"}, {"int32_t", "cstdint"},
        {"uint32_t", "cstdint"},       {"int64_t", "cstdint"},      {"uint64_t", "cstdint"}};
    std::set<std::string> headers;
    for (const std::string& type : types) {
        for (const auto& [name, header] : known) {
            if (containsWord(type, name)) headers.insert(header);
        }
    }
    return {headers.begin(), headers.end()};
}

std::string identifier(const std::string& packageName) {
    std::string result = packageName;
    for (char& c : result) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    }
    return result;
}

std::string className(const std::string& packageName) {
    std::string result = identifier(packageName);
    if (!result.empty()) result[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(result[0])));
    return result;
}

std::string guardName(const std::string& text) {
    std::string result = identifier(text);
    for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return result;
}

std::string namespaceOf(const std::string& qualified) {
    const auto at = qualified.rfind("::");
    return at == std::string::npos ? std::string() : qualified.substr(0, at);
}

std::string lastName(const std::string& qualified) { return model::splitQualified(qualified).back(); }

}  // namespace oroforge::view
