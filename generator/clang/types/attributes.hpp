// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The attributes [[oro::unit("m")]], [[oro::range(0, 5)]], [[oro::doc("text")]], [[oro::skip]] and so on of fields and types.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_ATTRIBUTES_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_ATTRIBUTES_HPP

#include <string>
#include <vector>

#include "doc_comment.hpp"

namespace oroforge::cxx {

/// They stand before the declaration; behind a name they count for nothing. Clang drops attributes that it does not know
/// before anybody can see them, so they are taken from the tokens.
class Attributes {
public:
    /// To be called before anything is read, and take() with each token that is.
    void watch(clang::Preprocessor& preprocessor) { preprocessor_ = &preprocessor; }
    void take(const clang::Token& token);

    /// What they say comes before what a comment says. The same by __attribute__((annotate("oro.unit=m"))).
    void addTo(DocComment& doc, const clang::Decl& declaration) const;

    struct Note {
        std::string name, value;
        clang::SourceLocation at;
    };
    /// In the order of the text.
    const std::vector<Note>& notes() const { return notes_; }

private:
    void takeInside(const clang::Token& token);
    void endAttribute(clang::SourceLocation at);

    clang::Preprocessor* preprocessor_ = nullptr;
    std::vector<Note> notes_;
    unsigned brackets_ = 0;   // "[" that follow each other, up to two: within an attribute list
    unsigned depth_ = 0;      // of parentheses within it
    unsigned closing_ = 0;    // tokens from "]" to the one behind "]]"
    std::size_t before_ = 0;  // notes before this list
    bool isOurs_ = false;     // the attribute begins with oro::
    std::string name_, value_;
};

}  // namespace oroforge::cxx

#endif
