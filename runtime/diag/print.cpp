// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <diag/print.hpp>

#include <ostream>

namespace oroforge::diag {

namespace {

const char* word(Severity severity) {
    switch (severity) {
        case Severity::Error: return "error";
        case Severity::Warning: return "warning";
        case Severity::Note: return "note";
    }
    return "error";
}

std::string prefixed(const Location& where, const std::string& rest) {
    const std::string place = toString(where);
    return place.empty() ? rest : place + ": " + rest;
}

/// White space as wide as the first `bytes` bytes of `line`: tabs stay tabs, and the
/// continuation bytes of UTF-8 take no room.
std::string padding(const std::string& line, std::size_t bytes) {
    std::string result;
    for (std::size_t i = 0; i < bytes && i < line.size(); ++i) {
        const unsigned char c = static_cast<unsigned char>(line[i]);
        if ((c & 0xC0U) != 0x80U) result += c == '\t' ? '\t' : ' ';
    }
    return result;
}

void printSource(std::ostream& out, const Location& where, SourceCache& sources) {
    const auto line = sources.line(where.file, where.line);
    if (!line) return;
    out << *line << '\n';
    if (where.column != 0) out << padding(*line, where.column - 1) << "^\n";
}

}  // namespace

std::string toString(const Location& where) {
    std::string text = where.file;
    if (where.line == 0) return text;
    text += (text.empty() ? "line " : ":") + std::to_string(where.line);
    if (where.column != 0) text += ":" + std::to_string(where.column);
    return text;
}

std::string toString(const Diagnostic& diagnostic) {
    std::string text = word(diagnostic.severity);
    text += ": ";
    if (!diagnostic.code.empty()) text += "[" + diagnostic.code + "] ";
    return prefixed(diagnostic.where, text + diagnostic.message);
}

void print(std::ostream& out, const Diagnostic& diagnostic, SourceCache& sources) {
    out << toString(diagnostic) << '\n';
    printSource(out, diagnostic.where, sources);
    for (const Note& note : diagnostic.notes) {
        out << prefixed(note.where, "note: " + note.message) << '\n';
        printSource(out, note.where, sources);
    }
}

void print(std::ostream& out, const Sink& sink, SourceCache& sources) {
    for (const Diagnostic& diagnostic : sink.sorted()) print(out, diagnostic, sources);
}

void print(std::ostream& out, const Sink& sink) {
    SourceCache sources;
    print(out, sink, sources);
}

}  // namespace oroforge::diag
