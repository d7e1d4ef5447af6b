// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <driver/build_file.hpp>

#include <regex>

namespace oroforge::driver {

namespace {

/// Blanks out comments and quoted text, so that only commands are found.
std::string withoutComments(const std::string& cmake) {
    std::string text = cmake;
    char inside = 0;  // '#' in a comment, '"' in a quoted text
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = cmake[i];
        if (inside == 0 && (c == '#' || c == '"')) {
            inside = c;
        } else if ((inside == '#' && c == '\n') || (inside == '"' && c == '"' && cmake[i - 1] != '\\')) {
            inside = 0;
        }
        if (inside == '#') text[i] = ' ';
    }
    return text;
}

}  // namespace

std::optional<Command> findCommand(const std::string& cmake, const std::string& name) {
    const std::string text = withoutComments(cmake);
    const std::regex pattern("(^|\\n)([ \\t]*)" + name + "[ \\t]*\\([ \\t\\r\\n]*([^ \\t\\r\\n)]*)", std::regex::icase);
    std::smatch match;
    if (!std::regex_search(text, match, pattern)) return std::nullopt;
    Command command;
    command.begin = static_cast<std::size_t>(match.position(2));
    command.close = text.find(')', static_cast<std::size_t>(match.position(3)));
    command.first = match[3];
    if (command.close == std::string::npos) return std::nullopt;
    return command;
}

std::size_t endOfNames(const std::string& cmake, const Command& call) {
    const std::string arguments = withoutComments(cmake).substr(call.begin, call.close - call.begin);
    std::smatch keyword;
    if (!std::regex_search(arguments, keyword, std::regex("[ \\t\\r\\n]+[A-Z_]+(?=[ \\t\\r\\n]|$)"))) return call.close;
    return call.begin + static_cast<std::size_t>(keyword.position());
}

bool addBehind(std::string& cmake, const std::string& known, const std::string& fresh) {
    const std::string text = withoutComments(cmake);
    const auto is = [&](std::size_t at, const char* among) {
        return at >= text.size() || std::string(among).find(text[at]) != std::string::npos;
    };
    for (std::size_t at = text.find(known); at != std::string::npos; at = text.find(known, at + 1)) {
        const std::size_t end = at + known.size();
        if ((at > 0 && !is(at - 1, " \t\n(")) || !is(end, " \t\r\n)")) continue;
        const std::size_t line = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
        const std::string indent = text.substr(line, at - line);
        const bool alone = indent.find_first_not_of(" \t") == std::string::npos && is(end, "\r\n");
        const std::string lineEnd = end < text.size() && text[end] == '\r' ? "\r\n" : "\n";
        cmake.insert(end, (alone ? lineEnd + indent : " ") + fresh);
        return true;
    }
    return false;
}

}  // namespace oroforge::driver
