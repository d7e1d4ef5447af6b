// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Handles lines, blanks and comments of C++ text.
#ifndef OROFORGE_GENERATOR_MERGE_TEXT_PLACES_HPP
#define OROFORGE_GENERATOR_MERGE_TEXT_PLACES_HPP

#include <string>
#include <vector>

#include <model/user_code.hpp>

namespace oroforge::merge {

std::string cut(const std::string& text, model::Span span);

/// Returns "\r\n" if most lines end with it.
std::string lineEndOf(const std::string& text);

std::size_t lineBegin(const std::string& text, std::size_t at);
/// Returns the blanks at the beginning of the line.
std::string indentAt(const std::string& text, std::size_t at);
/// True if only blanks are before it in its line.
bool isFirstInLine(const std::string& text, std::size_t at);

/// Returns where a new line can begin after an item that ends at `at`: after its trailing comments, and after lines
/// that continue these. Returns `at` itself if more code follows in the line.
std::size_t behindItem(const std::string& text, std::size_t at);

/// Returns where the comment directly above an item begins; `at` is the item's beginning.
std::size_t withComment(const std::string& text, std::size_t at);

bool blankAbove(const std::string& text, std::size_t lineStart);

bool isBlank(const std::string& text);
bool hasComment(const std::string& text);

/// True if the text contains the name as a word, outside comments and strings as far as part of a text shows this.
bool mentions(const std::string& text, const std::string& name);

/// Returns the words of C++ with one blank where two would merge: texts that differ only in layout become equal.
std::string withoutLayout(const std::string& text);

/// "int level" → {"int", "level"}
model::TypedName splitTyped(const std::string& text);

/// "bool finish(int sent, int refused)"
std::string toText(const model::Signature& signature, const std::string& name);

}  // namespace oroforge::merge

#endif
