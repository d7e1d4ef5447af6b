// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "format_inserted.hpp"

#include <algorithm>
#include <optional>

#include <clang/base/large_stack.hpp>
#include <clang/base/llvm_compat.hpp>

namespace oroforge::cxx {

namespace {

using clang::format::FormatStyle;
using llvm::StringRef;
using model::Span;

const char* const kBlanks = " \t\r\n\f\v";

bool isBlank(StringRef text) { return text.find_first_not_of(kBlanks) == StringRef::npos; }

// getStyle() passes no context to its handler.
thread_local std::vector<llvm::SMDiagnostic>* styleMessages = nullptr;

/// Returns the nearest .clang-format or _clang-format; "" if there is none.
std::string styleFileFor(StringRef file) {
    for (StringRef folder = llvm::sys::path::parent_path(file); !folder.empty();
         folder = llvm::sys::path::parent_path(folder)) {
        for (const char* name : {"/.clang-format", "/_clang-format"})
            if (llvm::sys::fs::is_regular_file(folder + name)) return (folder + name).str();
    }
    return {};
}

/// Reports what is wrong with a style; `isIgnored` if the rest of it counts.
void report(const FormatRequest& request, diag::Location where, std::string why, bool isIgnored, diag::Sink& sink) {
    StringRef file = where.file.str();
    if (file.consume_front(request.root + "/")) where.file = request.shown + file.str();
    why[0] = llvm::toLower(why[0]);
    sink.warning(std::move(where), "OC043",
                 isIgnored ? why + ": this line is ignored"
                           : "this style cannot be used: " + why + "; new code looks like the code around it");
}

std::optional<FormatStyle> styleFor(const FormatRequest& request, diag::Sink& sink) {
    const std::string path = request.root + "/" + request.file;
    const std::string styleFile = styleFileFor(path);
    if (styleFile.empty()) return std::nullopt;
    std::vector<llvm::SMDiagnostic> messages;
    styleMessages = &messages;
    const auto keep = [](const llvm::SMDiagnostic& message, void*) { styleMessages->push_back(message); };
    llvm::Expected<FormatStyle> style =
        clang::format::getStyle("file", path, "LLVM", request.text, nullptr, /*AllowUnknownOptions=*/true, keep);
    styleMessages = nullptr;
    for (const llvm::SMDiagnostic& one : messages) {
        const diag::Location where{one.getFilename().str(), static_cast<unsigned>(one.getLineNo()),
                                   static_cast<unsigned>(one.getColumnNo() + 1)};
        report(request, where, one.getMessage().str(), one.getKind() == llvm::SourceMgr::DK_Warning, sink);
    }
    if (style) return *style;
    const std::string why = llvm::toString(style.takeError());
    if (messages.empty()) report(request, {styleFile, 0, 0}, why, false, sink);
    return std::nullopt;
}

/// Returns the inserted part of the blanks in front of a token: `theirs` are the user's and stay, `ours` are inserted
/// behind them, and `wanted` is what should be there.
StringRef ownBlanks(StringRef theirs, StringRef ours, StringRef wanted) {
    const bool hadLine = theirs.contains('\n') || ours.contains('\n');
    // Lines that are inserted stay lines, whatever the user's line above ends with.
    if (hadLine != wanted.contains('\n')) return ours;
    if (wanted.consume_front(theirs)) return wanted;
    const std::size_t lines = theirs.count('\n');
    if (lines != 0 && !theirs.ends_with("\n")) return ours;
    for (std::size_t i = 0; i != lines && wanted.contains('\n'); ++i) wanted = wanted.drop_front(wanted.find('\n') + 1);
    return wanted;
}

/// Returns `span` without blanks at its ends.
Span wordsOf(StringRef text, Span span) {
    const StringRef words = text.slice(span.begin, span.end).ltrim(kBlanks);
    const std::size_t begin = span.end - words.size();
    return {begin, begin + words.rtrim(kBlanks).size()};
}

/// Returns the new bytes of `span`: only changes up to its last word count.
std::string changed(StringRef text, Span span, const clang::tooling::Replacements& changes) {
    std::string result;
    const Span words = wordsOf(text, span);
    std::size_t at = span.begin;
    for (const clang::tooling::Replacement& one : changes) {
        const std::size_t begin = one.getOffset(), end = begin + one.getLength();
        if (end < span.begin || end > words.end || begin >= words.end) continue;
        const StringRef wanted = one.getReplacementText();
        const bool blank = isBlank(text.slice(begin, end)) && isBlank(wanted);
        if (begin >= span.begin && (begin > words.begin || end > words.begin || !blank)) {
            result += text.slice(at, begin).str() + wanted.str();
        } else if (blank) {
            result += ownBlanks(text.slice(begin, span.begin), text.slice(span.begin, end), wanted).str();
        } else {
            continue;
        }
        at = end;
    }
    return result + text.slice(at, span.end).str();
}

}  // namespace

std::vector<std::string> formatInserted(const FormatRequest& request, diag::Sink& sink) {
    const StringRef text = request.text;
    clang::tooling::Replacements changes;
    if (std::optional<FormatStyle> style = styleFor(request, sink)) {
        // Their changes are outside of what is inserted, and each takes a pass over the file: half of the time.
        style->FixNamespaceComments = false;
        style->SortUsingDeclarations = FormatStyle::SUD_Never;
        style->LineEnding = 2 * text.count("\r\n") > text.count('\n') ? FormatStyle::LE_CRLF : FormatStyle::LE_LF;
        std::vector<clang::tooling::Range> ranges;
        for (const Span& span : request.inserted) {
            const Span words = wordsOf(text, span);
            if (!words.empty())
                ranges.emplace_back(static_cast<unsigned>(words.begin), static_cast<unsigned>(words.end - words.begin));
        }
        // It recurses for every level of nesting, as the compiler does.
        runOnLargeStack([&] {
            clang::format::FormattingAttemptStatus status;
            changes = clang::format::reformat(*style, text, ranges, request.file, &status);
            if (!status.FormatComplete) changes.clear();
        });
    }
    std::vector<std::string> result;
    for (const Span& span : request.inserted) result.push_back(changed(text, span, changes));
    return result;
}

}  // namespace oroforge::cxx
