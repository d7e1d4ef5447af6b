// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Which bytes of a member function are its type, name, arguments and body.
#ifndef OROFORGE_GENERATOR_CLANG_UPDATE_FUNCTION_SPANS_HPP
#define OROFORGE_GENERATOR_CLANG_UPDATE_FUNCTION_SPANS_HPP

#include <model/user_code.hpp>

#include "source_run.hpp"

namespace oroforge::cxx {

/// Words of a text from some place on, comments left out.
class Words {
public:
    Words(const clang::ASTContext& context, clang::SourceLocation from) : context_(context), at_(from) {}

    /// The next word; false at the end of the file.
    bool next(clang::Token& token);
    std::string spelled(const clang::Token& token) const;

private:
    const clang::ASTContext& context_;
    clang::SourceLocation at_;
};

/// From a place up to and with the next ';' outside of brackets.
clang::SourceLocation behindSemicolon(const clang::ASTContext& context, clang::SourceLocation from);

/// Just behind the word that begins there.
clang::SourceLocation behindWord(const clang::ASTContext& context, clang::SourceLocation at);

/// What stands between the braces of the namespace around; the whole file if there is none.
model::Span scopeAround(const clang::Decl& declaration, const PackagePlaces& places);

/// All of a function but its name and access. `outer` is the template around it, or the function itself.
void fillSpans(const clang::CXXMethodDecl& function, const clang::Decl& outer, const PackagePlaces& places,
               model::UserFunction& into);

model::CanonicalSignature canonicalSignature(const clang::FunctionDecl& function);

}  // namespace oroforge::cxx

#endif
