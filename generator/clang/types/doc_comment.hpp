// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Documentation comments (///, /** */, ///<) of declarations.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_DOC_COMMENT_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_DOC_COMMENT_HPP

#include <string>

#include <clang/base/llvm_compat.hpp>

namespace oroforge::cxx {

struct DocComment {
    std::string text;      ///< without marks; lines joined by blanks, paragraphs by a newline
    std::string unit;      ///< what follows "@unit"
    std::string range;     ///< what follows "@range"
    std::string capacity;  ///< what follows "@capacity": for how many elements there is room
    std::string make;      ///< what follows "@make": C++ of a value of the type
    bool skip = false;     ///< "@skip": not to be described
    bool asText = false;   ///< "@text": an array of characters is a string
    bool bytes = false;    ///< "@bytes": a union is its bytes
    bool byValue = false;  ///< "@by_value": a smart pointer is what it points to, or nothing
};

DocComment docComment(const clang::ASTContext& context, const clang::Decl& declaration);

/// The same from the bare text of a comment.
DocComment parseDocText(const std::string& text);

}  // namespace oroforge::cxx

#endif
