// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Reads attributes of fields and types: [[oro::unit("m")]], [[oro::range(0, 5)]], [[oro::doc("text")]], [[oro::skip]].
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_ATTRIBUTES_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_ATTRIBUTES_HPP

#include <string>
#include <vector>

#include "doc_comment.hpp"

namespace oroforge::cxx {

/// Attributes must be before the declaration; after a name they are ignored. Clang drops unknown attributes before the
/// AST is built, so they are read from the tokens.
class Attributes {
public:
    /// Call this before anything is read, and take() with each token.
    void watch(clang::Preprocessor& preprocessor) { preprocessor_ = &preprocessor; }
    void take(const clang::Token& token);

    /// Attributes override comments. __attribute__((annotate("oro.unit=m"))) has the same effect.
    void addTo(DocComment& doc, const clang::Decl& declaration) const;

    struct Note {
        std::string name, value;
        clang::SourceLocation at;
    };
    /// Returns them in the order of the text.
    const std::vector<Note>& notes() const { return notes_; }

private:
    void takeInside(const clang::Token& token);
    void endAttribute(clang::SourceLocation at);

    clang::Preprocessor* preprocessor_ = nullptr;
    std::vector<Note> notes_;
    unsigned brackets_ = 0;   // consecutive "[", up to two: within an attribute list
    unsigned depth_ = 0;      // of parentheses within the list
    unsigned closing_ = 0;    // tokens from "]" to the one after "]]"
    std::size_t before_ = 0;  // notes before this list
    bool isOurs_ = false;     // the attribute begins with oro::
    std::string name_, value_;
};

}  // namespace oroforge::cxx

#endif
