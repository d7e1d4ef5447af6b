// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Names types in C++, in the type registry and in messages.
#ifndef OROFORGE_GENERATOR_CLANG_BASE_TYPE_NAMES_HPP
#define OROFORGE_GENERATOR_CLANG_BASE_TYPE_NAMES_HPP

#include <optional>
#include <string>
#include <vector>

#include "llvm_compat.hpp"

namespace oroforge::cxx {

struct TypeName {
    std::string cpp;       ///< "::demo::Point"
    std::string registry;  ///< "/demo/Point"
};

/// Returns the names of a class or enum; nothing if it cannot be named (unnamed type, unusual template arguments).
std::optional<TypeName> nameOf(const clang::TagDecl& type);

/// Returns the names of its template arguments, with packs expanded; nothing if one of them has none.
std::optional<std::vector<TypeName>> argumentsOf(const clang::ClassTemplateSpecializationDecl& type);

/// Returns the first argument without a name of a template instance, as C++ writes it.
std::string unnamedArgument(const clang::TagDecl& type);

/// Returns "::demo"; empty for the global namespace.
std::string namespaceOf(const clang::TagDecl& type);

/// Returns the name of an alias in the type registry; nothing if its scope has none.
std::optional<std::string> nameOf(const clang::TypedefNameDecl& alias);

/// Returns the names of a number type; nothing for types that typekits do not have (__int128, char8_t, half floats).
std::optional<TypeName> nameOf(const clang::BuiltinType& type, const clang::ASTContext& context);

/// Returns the name in messages: "demo::Point", "unnamed struct" …
std::string shownName(const clang::TagDecl& type);

/// Returns the type in messages, as the user spelled it.
std::string shownName(clang::QualType type, const clang::ASTContext& context);

/// Returns the name of its outermost namespace; empty for the global one.
llvm::StringRef outermostNamespace(const clang::Decl& declaration);

/// True if it is anywhere within namespace std.
bool isStandard(const clang::Decl& declaration);

/// True if it is std::<name>; inline namespaces are ignored.
bool isStandard(const clang::CXXRecordDecl& type, const char* name);

}  // namespace oroforge::cxx

#endif
