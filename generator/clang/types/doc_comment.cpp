// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "doc_comment.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include <xml/escape.hpp>

namespace oroforge::cxx {

namespace {

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// Returns the position of "@word" or "\\word" as a separate word, or npos.
std::size_t findCommand(const std::string& line, const std::string& word) {
    for (std::size_t at = line.find(word, 1); at != std::string::npos; at = line.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        const bool marked = line[at - 1] == '@' || line[at - 1] == '\\';
        if (marked && (end == line.size() || line[end] == ' ')) return at - 1;
    }
    return std::string::npos;
}

/// Cuts the command and the text up to the next command off `line`; returns that text.
std::string takeRest(std::string& line, const std::string& word) {
    const std::size_t at = findCommand(line, word);
    if (at == std::string::npos) return {};
    const std::size_t begin = at + 1 + word.size();
    const std::size_t end = std::min(line.find_first_of("@\\", begin), line.size());
    const std::string rest = trimmed(line.substr(begin, end - begin));
    line = trimmed(trimmed(line.substr(0, at)) + " " + line.substr(end));
    return rest;
}

/// Cuts the command off `line`.
bool takeFlag(std::string& line, const std::string& word) {
    const std::size_t at = findCommand(line, word);
    if (at == std::string::npos) return false;
    line = trimmed(line.erase(at, word.size() + 1));
    return true;
}

/// Cuts all commands off `line`; true if there was one.
bool takeCommands(std::string& line, DocComment& doc) {
    bool any = false;
    const std::pair<const char*, bool DocComment::*> flags[] = {{"skip", &DocComment::skip},
                                                                {"text", &DocComment::asText},
                                                                {"bytes", &DocComment::bytes},
                                                                {"by_value", &DocComment::byValue}};
    for (const auto& [word, flag] : flags) {
        if (!takeFlag(line, word)) continue;
        doc.*flag = any = true;
    }
    if (findCommand(line, "ros") != std::string::npos) {
        doc.ros = takeRest(line, "ros");
        if (doc.ros.empty()) doc.ros = " ";
        any = true;
    }
    const std::pair<const char*, std::string DocComment::*> values[] = {{"range", &DocComment::range},
                                                                        {"unit", &DocComment::unit},
                                                                        {"capacity", &DocComment::capacity},
                                                                        {"make", &DocComment::make}};
    for (const auto& [word, value] : values) {
        const std::string rest = takeRest(line, word);
        if (rest.empty()) continue;
        doc.*value = rest;
        any = true;
    }
    return any;
}

}  // namespace

DocComment parseDocText(const std::string& text) {
    DocComment doc;
    bool paragraph = false;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        line = trimmed(line);
        const bool commands = takeCommands(line, doc);
        if (findCommand(line, "brief") == 0) line = trimmed(line.substr(6));
        if (line.empty()) {
            if (commands) continue;
            paragraph = !doc.text.empty();
            continue;
        }
        if (!doc.text.empty()) doc.text += paragraph ? '\n' : ' ';
        doc.text += line;
        paragraph = false;
    }
    return doc;
}

DocComment docComment(const clang::ASTContext& context, const clang::Decl& declaration) {
    DocComment doc;
    if (const clang::RawComment* comment = context.getRawCommentForAnyRedecl(&declaration))
        doc =
            parseDocText(xml::asUtf8(comment->getFormattedText(context.getSourceManager(), context.getDiagnostics())));
    return doc;
}

}  // namespace oroforge::cxx
