// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Reads documentation comments (///, /** */, ///<) of declarations.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_DOC_COMMENT_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_DOC_COMMENT_HPP

#include <string>

#include <clang/base/llvm_compat.hpp>

namespace oroforge::cxx {

struct DocComment {
    std::string text;      ///< without comment marks; blanks join lines, a newline separates paragraphs
    std::string unit;      ///< text after "@unit"
    std::string range;     ///< text after "@range"
    std::string capacity;  ///< text after "@capacity": number of elements that it has room for
    std::string make;      ///< text after "@make": C++ that makes a value of the type
    std::string ros;       ///< text after "@ros": the message of ROS that the type is; " " if there is none
    bool skip = false;     ///< "@skip": do not describe it
    bool asText = false;   ///< "@text": show an array of characters as a string
    bool bytes = false;    ///< "@bytes": show a union as its bytes
    bool byValue = false;  ///< "@by_value": show the pointee of a smart pointer, or nothing
};

DocComment docComment(const clang::ASTContext& context, const clang::Decl& declaration);

/// Parses the text of a comment without its marks.
DocComment parseDocText(const std::string& text);

}  // namespace oroforge::cxx

#endif
