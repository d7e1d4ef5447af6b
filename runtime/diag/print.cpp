// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <diag/print.hpp>

#include <algorithm>
#include <cerrno>
#include <ostream>
#include <system_error>

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

bool isInnerByte(char letter) { return (static_cast<unsigned char>(letter) & 0xC0U) == 0x80U; }

/// White space as wide as the first `bytes` bytes of `line`: tabs stay tabs, continuation bytes of UTF-8 have no width.
std::string padding(const std::string& line, std::size_t bytes) {
    std::string result;
    for (std::size_t i = 0; i < bytes && i < line.size(); ++i) {
        if (!isInnerByte(line[i])) result += line[i] == '\t' ? '\t' : ' ';
    }
    return result;
}

std::string withoutLineEnd(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
    return text;
}

/// What the fixes put into this line, each below its place; a fix that would overlap the previous one is left out.
std::string belowLine(const std::string& line, const Location& where, const std::vector<Fix>& fixes) {
    std::string below;
    std::size_t end = 0;  // column in `line` up to which it is written
    std::vector<Fix> here;
    for (const Fix& fix : fixes) {
        const bool inLine = fix.begin.file == where.file && fix.begin.line == where.line && fix.begin.column != 0;
        if (inLine && !fix.replacement.empty() && fix.replacement.find('\n') == std::string::npos) here.push_back(fix);
    }
    std::sort(here.begin(), here.end(), [](const Fix& a, const Fix& b) { return a.begin < b.begin; });
    for (const Fix& fix : here) {
        const std::size_t start = fix.begin.column - 1;
        if (start < end || start > line.size()) continue;
        below += padding(line, start).substr(padding(line, end).size()) + fix.replacement;
        end = start + fix.replacement.size();
    }
    return below;
}

constexpr std::size_t kWidest = 300;  // bytes of a line that are shown
constexpr std::size_t kBefore = 100;  // those before the caret, if the line is longer

/// Spells control characters out, so that text of a user cannot pass for a line of this program or control the
/// terminal.
std::string printable(const std::string& text) {
    static constexpr char digits[] = "0123456789abcdef";
    std::string result;
    for (const char c : text) {
        const auto u = static_cast<unsigned char>(c);
        if (u >= 0x20U && u != 0x7FU)
            result += c;
        else if (c == '\n')
            result += "\\n";
        else if (c == '\t')
            result += "\\t";
        else
            result += std::string("\\x") + digits[u >> 4U] + digits[u & 15U];
    }
    return result;
}

/// The same for a line of source, without moving its columns.
std::string printableLine(std::string line) {
    for (char& c : line)
        if ((static_cast<unsigned char>(c) < 0x20U && c != '\t') || c == '\x7f') c = '?';
    return line;
}

/// The shown part of a very long line, with "..." where something is left out; `shift` is the number of bytes left out
/// before it.
std::string shownPart(const std::string& line, std::size_t column, std::size_t& shift) {
    shift = 0;
    if (line.size() <= kWidest) return line;
    std::size_t end = kWidest;
    if (column > kWidest && column <= line.size()) {
        shift = column - kBefore;
        while (isInnerByte(line[shift])) ++shift;
        end = std::min(line.size(), shift + kWidest);
    }
    while (end < line.size() && isInnerByte(line[end])) ++end;
    return (shift == 0 ? "" : "...") + line.substr(shift, end - shift) + (end == line.size() ? "" : "...");
}

void printSource(std::ostream& out, const Location& where, const std::vector<Fix>& fixes, SourceCache& sources) {
    const std::string* const line = sources.line(where.file, where.line);
    if (!line) return;
    std::size_t shift = 0;
    const std::string shown = shownPart(*line, where.column, shift);
    out << printableLine(shown) << '\n';
    if (where.column != 0) out << padding(shown, where.column - 1 - shift + (shift == 0 ? 0 : 3)) << "^\n";
    const std::string below = shown == *line ? belowLine(*line, where, fixes) : "";
    if (!below.empty()) out << below << '\n';
}

/// The text that the fix replaces, if that is within one line that can be read.
std::string replacedText(const Fix& fix, SourceCache& sources) {
    if (fix.begin.line != fix.end.line || fix.begin.column == 0 || fix.end.column < fix.begin.column) return {};
    const std::string* const line = sources.line(fix.begin.file, fix.begin.line);
    if (!line || fix.begin.column > line->size()) return {};
    return line->substr(fix.begin.column - 1, fix.end.column - fix.begin.column);
}

std::string quoted(const std::string& text) { return "'" + withoutLineEnd(text) + "'"; }

void printFixes(std::ostream& out, const std::vector<Fix>& fixes, SourceCache& sources) {
    for (const Fix& fix : fixes) {
        std::string text = "insert " + quoted(fix.replacement);
        if (fix.begin != fix.end) {
            const std::string old = replacedText(fix, sources);
            const std::string what =
                old.empty() ? "all up to " + toString({{}, fix.end.line, fix.end.column}) : quoted(old);
            text = fix.replacement.empty() ? "remove " + what : "replace " + what + " with " + quoted(fix.replacement);
        }
        out << prefixed(fix.begin, "fix-it: " + text) << '\n';
    }
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
    return printable(prefixed(diagnostic.where, text + diagnostic.message));
}

void print(std::ostream& out, const Diagnostic& diagnostic, SourceCache& sources) {
    out << toString(diagnostic) << '\n';
    printSource(out, diagnostic.where, diagnostic.fixes, sources);
    printFixes(out, diagnostic.fixes, sources);
    for (const Note& note : diagnostic.notes) {
        out << printable(prefixed(note.where, "note: " + note.message)) << '\n';
        printSource(out, note.where, note.fixes, sources);
        printFixes(out, note.fixes, sources);
    }
}

void print(std::ostream& out, const Sink& sink, SourceCache& sources) {
    for (const Diagnostic& diagnostic : sink.sorted()) print(out, diagnostic, sources);
}

void print(std::ostream& out, const Sink& sink) {
    SourceCache sources;
    print(out, sink, sources);
}

bool arrived(std::ostream& out, std::ostream& err, const std::string& program, const std::string& code) {
    errno = 0;
    if (out.flush()) return true;
    int reason = errno;
    if (reason == 0) {
        // It failed earlier and the reason was not kept: another try fails for the same one.
        out.clear();
        out.put('\n').flush();
        reason = errno;
        out.setstate(std::ios::badbit);
    }
    Diagnostic failure;
    failure.code = code;
    failure.where.file = program;
    failure.message = "cannot write to standard output";
    if (reason != 0) failure.message += ": " + std::generic_category().message(reason);
    err << toString(failure) << '\n';
    return false;
}

}  // namespace oroforge::diag
