// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds the bytes of a member function's type, name, arguments and body.
#ifndef OROFORGE_GENERATOR_CLANG_UPDATE_FUNCTION_SPANS_HPP
#define OROFORGE_GENERATOR_CLANG_UPDATE_FUNCTION_SPANS_HPP

#include <model/user_code.hpp>

#include "source_run.hpp"

namespace oroforge::cxx {

/// Reads the words of a text from a place on, without comments.
class Words {
public:
    Words(const clang::ASTContext& context, clang::SourceLocation from) : context_(context), at_(from) {}

    /// Reads the next word; false at the end of the file.
    bool next(clang::Token& token);
    std::string spelled(const clang::Token& token) const;

private:
    const clang::ASTContext& context_;
    clang::SourceLocation at_;
};

/// Returns the place after the next ';' outside brackets.
clang::SourceLocation behindSemicolon(const clang::ASTContext& context, clang::SourceLocation from);

/// Returns the place after the word that begins at `at`.
clang::SourceLocation behindWord(const clang::ASTContext& context, clang::SourceLocation at);

/// Returns the text between the braces of the enclosing namespace; the whole file if there is none.
model::Span scopeAround(const clang::Decl& declaration, const PackagePlaces& places);

/// Fills in everything but name and access. `outer` is the template around the function, or the function itself.
void fillSpans(const clang::CXXMethodDecl& function, const clang::Decl& outer, const PackagePlaces& places,
               model::UserFunction& into);

model::CanonicalSignature canonicalSignature(const clang::FunctionDecl& function);

}  // namespace oroforge::cxx

#endif
