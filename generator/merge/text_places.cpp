// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <merge/text_places.hpp>

#include <algorithm>
#include <cctype>

#include <model/cpp_type.hpp>

namespace oroforge::merge {

namespace {

const char* const kBlanks = " \t\r\n\f\v";

bool isWordLetter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::size_t lineEnd(const std::string& text, std::size_t at) {
    const std::size_t newline = text.find('\n', at);
    return newline == std::string::npos ? text.size() : newline + 1;
}

/// Returns the place after the '\n' of a line comment; a backslash at the end continues it in the next line.
std::size_t behindLineComment(const std::string& text, std::size_t at) {
    for (;;) {
        const std::size_t end = lineEnd(text, at);
        std::size_t last = end;
        while (last > at && (text[last - 1] == '\n' || text[last - 1] == '\r')) --last;
        if (end == text.size() || last == at || text[last - 1] != '\\') return end;
        at = end;
    }
}

std::string trimmed(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(kBlanks);
    if (begin == std::string::npos) return {};
    return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

/// True if a line continues the comment after a member.
bool continuesComment(const std::string& line, std::size_t indent) {
    const std::string text = trimmed(line);
    if (text.compare(0, 4, "///<") == 0 || text.compare(0, 4, "//!<") == 0) return true;
    return text.compare(0, 2, "//") == 0 && line.find_first_not_of(" \t") > indent;
}

}  // namespace

std::string cut(const std::string& text, model::Span span) { return text.substr(span.begin, span.end - span.begin); }

std::string lineEndOf(const std::string& text) {
    std::size_t lines = 0, withReturn = 0;
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) {
        ++lines;
        if (at > 0 && text[at - 1] == '\r') ++withReturn;
    }
    return 2 * withReturn > lines ? "\r\n" : "\n";
}

std::size_t lineBegin(const std::string& text, std::size_t at) {
    const std::size_t newline = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
    return newline == std::string::npos ? 0 : newline + 1;
}

std::string indentAt(const std::string& text, std::size_t at) {
    const std::size_t begin = lineBegin(text, at);
    const std::size_t end = text.find_first_not_of(" \t", begin);
    return text.substr(begin, (end == std::string::npos ? text.size() : end) - begin);
}

bool isFirstInLine(const std::string& text, std::size_t at) {
    return isBlank(text.substr(lineBegin(text, at), at - lineBegin(text, at)));
}

std::size_t behindItem(const std::string& text, std::size_t at) {
    const std::size_t indent = indentAt(text, at).size();
    std::size_t here = at;
    bool comment = false;
    for (;;) {
        here = text.find_first_not_of(" \t\r\f\v", here);
        if (here == std::string::npos) return text.size();
        if (text[here] == '\n') {
            ++here;
            break;
        }
        if (text.compare(here, 2, "//") == 0) {
            comment = true;
            here = behindLineComment(text, here);
            break;
        }
        // A backslash before the line's end only joins two lines.
        if (text[here] == '\\' && lineEnd(text, here) - here <= 3) {
            here = lineEnd(text, here);
            break;
        }
        const std::size_t end = text.compare(here, 2, "/*") == 0 ? text.find("*/", here + 2) : std::string::npos;
        if (end == std::string::npos) return at;
        here = end + 2;
    }
    while (comment && here < text.size() && continuesComment(text.substr(here, lineEnd(text, here) - here), indent))
        here = behindLineComment(text, here);
    return here;
}

std::size_t withComment(const std::string& text, std::size_t at) {
    std::size_t begin = lineBegin(text, at);
    bool inBlock = false;
    while (begin > 0) {
        const std::size_t above = lineBegin(text, begin - 1);
        const std::string line = trimmed(text.substr(above, begin - above));
        const bool opens = line.compare(0, 2, "/*") == 0;
        const bool closes = line.size() >= 2 && line.compare(line.size() - 2, 2, "*/") == 0;
        if (!inBlock && line.compare(0, 2, "//") != 0 && !closes) break;
        // "int a; /* … */" does not comment the item below.
        if (!inBlock && closes && !opens && line.find("/*") != std::string::npos) break;
        inBlock = inBlock ? !opens : closes && !opens;
        begin = above;
    }
    return begin;
}

bool blankAbove(const std::string& text, std::size_t lineStart) {
    if (lineStart == 0) return false;
    const std::size_t above = lineBegin(text, lineStart - 1);
    return isBlank(text.substr(above, lineStart - above));
}

bool isBlank(const std::string& text) { return text.find_first_not_of(kBlanks) == std::string::npos; }

bool hasComment(const std::string& text) {
    return text.find("//") != std::string::npos || text.find("/*") != std::string::npos;
}

bool mentions(const std::string& text, const std::string& name) {
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        if ((at == 0 || !isWordLetter(text[at - 1])) && (end == text.size() || !isWordLetter(text[end]))) return true;
    }
    return false;
}

std::string withoutLayout(const std::string& text) {
    std::string bare;
    for (std::size_t at = 0; at < text.size();) {
        if (text.compare(at, 2, "//") == 0) {
            at = behindLineComment(text, at);
            bare += ' ';
        } else if (text.compare(at, 2, "/*") == 0) {
            const std::size_t end = text.find("*/", at + 2);
            at = end == std::string::npos ? text.size() : end + 2;
            bare += ' ';
        } else {
            bare += text[at++];
        }
    }
    return model::normalised(bare);
}

model::TypedName splitTyped(const std::string& text) {
    const std::string whole = trimmed(text);
    std::size_t begin = whole.size();
    while (begin > 0 && isWordLetter(whole[begin - 1])) --begin;
    if (begin == 0) return {whole, ""};
    return {trimmed(whole.substr(0, begin)), whole.substr(begin)};
}

std::string toText(const model::Signature& signature, const std::string& name) {
    std::string text = signature.returns + " " + name + "(";
    for (const model::TypedName& argument : signature.arguments) {
        if (&argument != &signature.arguments.front()) text += ", ";
        text += argument.type + (argument.name.empty() ? "" : " " + argument.name);
    }
    return text + ")";
}

}  // namespace oroforge::merge
