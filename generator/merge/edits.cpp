// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <merge/edits.hpp>

#include <algorithm>
#include <cassert>

namespace oroforge::merge {

namespace {

void add(std::vector<Edit>& edits, Edit edit) {
    // Goes after all edits at the same place: the order of insertions is the order of the calls.
    const auto at = std::upper_bound(edits.begin(), edits.end(), edit.span.begin,
                                     [](std::size_t begin, const Edit& one) { return begin < one.span.begin; });
    edits.insert(at, std::move(edit));
}

}  // namespace

void Edits::replace(const std::string& file, model::Span span, const std::string& text) {
    add(byFile_[file], {span, text, false});
}

void Edits::insert(const std::string& file, std::size_t at, const std::string& text) {
    add(byFile_[file], {{at, at}, text, true});
}

void Edits::format(const std::map<std::string, std::string>& texts, const Formatter& formatter) {
    for (auto& [file, edits] : byFile_) {
        std::vector<Edit*> lines;
        std::vector<model::Span> inserted;
        std::size_t added = 0, removed = 0;
        for (Edit& edit : edits) {
            const std::size_t begin = edit.span.begin + added - removed;
            if (edit.isLines) lines.push_back(&edit), inserted.push_back({begin, begin + edit.text.size()});
            added += edit.text.size();
            removed += edit.span.end - edit.span.begin;
        }
        if (lines.empty()) continue;
        const std::vector<std::string> formatted = formatter(file, applied(texts.at(file), edits), inserted);
        for (std::size_t i = 0; i != lines.size(); ++i) lines[i]->text = formatted[i];
    }
}

std::string applied(const std::string& text, const std::vector<Edit>& edits) {
    std::string result;
    std::size_t at = 0;
    for (const Edit& edit : edits) {
        assert(edit.span.begin >= at && edit.span.end <= text.size());
        result.append(text, at, edit.span.begin - at);
        result += edit.text;
        at = edit.span.end;
    }
    return result.append(text, at, std::string::npos);
}

diag::Location moved(const diag::Location& where, const std::string& before, const std::vector<Edit>& edits) {
    if (where.line == 0) return where;
    std::size_t at = 0;
    for (unsigned line = 1; line < where.line && at < before.size(); ++line) at = before.find('\n', at) + 1;
    at += where.column == 0 ? 0 : where.column - 1;
    std::size_t now = at;
    for (const Edit& edit : edits) {
        if (edit.span.begin > at || edit.span.end > at) break;
        now += edit.text.size() - (edit.span.end - edit.span.begin);
    }
    const std::string after = applied(before, edits);
    diag::Location result = where;
    result.line =
        1 + static_cast<unsigned>(std::count(after.begin(), after.begin() + static_cast<std::ptrdiff_t>(now), '\n'));
    const std::size_t newline = now == 0 ? std::string::npos : after.rfind('\n', now - 1);
    if (where.column != 0)
        result.column = static_cast<unsigned>(now - (newline == std::string::npos ? 0 : newline + 1)) + 1;
    return result;
}

}  // namespace oroforge::merge
