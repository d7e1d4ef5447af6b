// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <merge/insertion.hpp>

#include <algorithm>

#include <merge/text_places.hpp>

namespace oroforge::merge {

namespace {

const model::Conditionals& conditionalsOf(const model::UserCode& code, const std::string& file) {
    static const model::Conditionals none;
    const auto found = code.conditionals.find(file);
    return found == code.conditionals.end() ? none : found->second;
}

bool holdsAllDefinitions(const model::Span& block, const model::UserClass& type, const std::string& file) {
    std::size_t count = 0;
    for (const model::UserFunction& function : type.functions) {
        if (function.file != file || function.inClass) continue;
        if (!block.holds(function.whole)) return false;
        ++count;
    }
    return count > 1;
}

/// Finds the outermost #if … #endif around the item that does not hold everything else as well.
const model::Span* blockAround(const Neighbour& item, const model::UserClass& type, const model::UserCode& code) {
    const model::Span* outermost = nullptr;
    for (const model::Span& block : conditionalsOf(code, item.file).blocks) {
        if (!block.holds(item.whole) || !item.scope.holds(block)) continue;
        const bool inClass = item.function != nullptr ? item.function->inClass : true;
        if (!inClass && holdsAllDefinitions(block, type, item.file)) continue;
        if (outermost == nullptr || block.holds(*outermost)) outermost = &block;
    }
    return outermost;
}

}  // namespace

Neighbour neighbour(const model::UserFunction& function) {
    return {function.file, function.whole, function.scope, &function};
}

Place placeBehind(const std::vector<Neighbour>& neighbours, const model::UserClass& type, const model::UserCode& code) {
    for (const Neighbour& one : neighbours) {
        if (blockAround(one, type, code) != nullptr) continue;
        return {one.file, behindItem(code.texts.at(one.file), one.whole.end), one.function, true};
    }
    if (neighbours.empty()) return {};
    const Neighbour& first = neighbours.front();
    return {first.file, blockAround(first, type, code)->end, first.function, true};
}

void insertLines(Edits& edits, const std::string& text, const std::string& file, std::size_t at,
                 const std::string& lines, const std::string& lineEnd, bool blankAboveIt) {
    std::string chunk = (blankAboveIt ? lineEnd : "") + lines;
    // The place is inside a line: the rest of the line follows the new text.
    if (at > 0 && text[at - 1] != '\n') chunk = lineEnd + chunk.substr(0, chunk.size() - lineEnd.size());
    edits.insert(file, at, chunk);
}

bool skippedLinesMention(const model::UserCode& code, const std::string& file, model::Span scope,
                         const std::string& name) {
    const auto& skipped = conditionalsOf(code, file).skipped;
    return std::any_of(skipped.begin(), skipped.end(), [&](const model::Span& lines) {
        return scope.begin <= lines.begin && lines.begin < scope.end && mentions(cut(code.texts.at(file), lines), name);
    });
}

}  // namespace oroforge::merge
