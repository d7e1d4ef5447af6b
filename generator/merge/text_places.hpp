// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Lines, blanks and comments of C++ text.
#ifndef OROFORGE_GENERATOR_MERGE_TEXT_PLACES_HPP
#define OROFORGE_GENERATOR_MERGE_TEXT_PLACES_HPP

#include <string>
#include <vector>

#include <model/user_code.hpp>

namespace oroforge::merge {

std::string cut(const std::string& text, model::Span span);

/// "\r\n" if most lines end so.
std::string lineEndOf(const std::string& text);

std::size_t lineBegin(const std::string& text, std::size_t at);
/// Blanks at the beginning of the line.
std::string indentAt(const std::string& text, std::size_t at);
/// Nothing but blanks stand before it in its line.
bool isFirstInLine(const std::string& text, std::size_t at);

/// Where a new line can begin behind an item that ends at `at`: after the comments behind it, and those lines below that
/// go on with such a comment. `at` itself if more code stands in the line.
std::size_t behindItem(const std::string& text, std::size_t at);

/// Where an item that begins at `at` begins with its comment: the lines of comments directly above it.
std::size_t withComment(const std::string& text, std::size_t at);

/// The line above that one is blank.
bool blankAbove(const std::string& text, std::size_t lineStart);

bool isBlank(const std::string& text);
bool hasComment(const std::string& text);

/// The name as a word of its own, outside of comments and strings as far as can be told from a part of a text.
bool mentions(const std::string& text, const std::string& name);

/// Words of C++ with one blank between two that would flow together: texts that differ in layout alone are equal.
std::string withoutLayout(const std::string& text);

/// "int level" → {"int", "level"}
model::TypedName splitTyped(const std::string& text);

/// "bool finish(int sent, int refused)"
std::string toText(const model::Signature& signature, const std::string& name);

}  // namespace oroforge::merge

#endif
