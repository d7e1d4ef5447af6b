// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <report/parts.hpp>

#include <cctype>
#include <cstring>

namespace oroforge::report {

const char* severityName(diag::Severity severity) {
    switch (severity) {
        case diag::Severity::Error: return "error";
        case diag::Severity::Warning: return "warning";
        case diag::Severity::Note: return "note";
    }
    return "error";
}

std::string codeOf(const diag::Diagnostic& diagnostic, const Tool& tool) {
    return diagnostic.code.empty() ? tool.unnamed : diagnostic.code;
}

bool isFile(const diag::Location& where, const Tool& tool) {
    return !where.file.empty() && (where.line != 0 || where.file.str() != tool.name);
}

bool isHint(const diag::Note& note) { return note.where.file.empty() && note.where.line == 0; }

std::string hintOf(const diag::Diagnostic& diagnostic) {
    std::string text;
    for (const diag::Note& note : diagnostic.notes) {
        if (isHint(note)) text += (text.empty() ? "" : "\n") + note.message;
    }
    return text;
}

std::string uriOf(const std::string& path) {
    static const char* const digits = "0123456789ABCDEF";
    std::string uri = !path.empty() && path[0] == '/' ? "file://" : "";
    for (const char letter : path) {
        const auto byte = static_cast<unsigned char>(letter);
        const bool plain = byte < 0x80U && (std::isalnum(byte) != 0 || std::strchr("/-._~", letter) != nullptr);
        if (plain && letter != '\0') {
            uri += letter;
        } else {
            uri += {'%', digits[byte >> 4U], digits[byte & 0xFU]};
        }
    }
    return uri;
}

unsigned characterColumn(const diag::Location& where, diag::SourceCache& sources) {
    const std::string* const line = sources.line(where.file, where.line);
    if (!line || where.column == 0) return where.column;
    unsigned column = where.column;
    for (std::size_t i = 0; i + 1 < where.column && i < line->size(); ++i) {
        if ((static_cast<unsigned char>((*line)[i]) & 0xC0U) == 0x80U) --column;
    }
    return column;
}

}  // namespace oroforge::report
