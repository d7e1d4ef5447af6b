// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Names of types: in C++, in the type registry and in messages.
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

/// Names of a class or enum; nothing if it cannot be named at all (unnamed type, exotic template arguments).
std::optional<TypeName> nameOf(const clang::TagDecl& type);

/// Names of its template arguments, those of packs one by one; nothing if one of them has none.
std::optional<std::vector<TypeName>> argumentsOf(const clang::ClassTemplateSpecializationDecl& type);

/// Of a template instance without a name: the first argument that is to blame, as C++ writes it.
std::string unnamedArgument(const clang::TagDecl& type);

/// "::demo", or nothing for the global one.
std::string namespaceOf(const clang::TagDecl& type);

/// Name of an alias in the type registry; nothing if its scope has none.
std::optional<std::string> nameOf(const clang::TypedefNameDecl& alias);

/// Names of a number type; nothing for those that typekits do not hold (__int128, char8_t, half floats).
std::optional<TypeName> nameOf(const clang::BuiltinType& type, const clang::ASTContext& context);

/// For messages: "demo::Point", "unnamed struct" …
std::string shownName(const clang::TagDecl& type);

/// For messages: the type as the user spelled it.
std::string shownName(clang::QualType type, const clang::ASTContext& context);

/// The name of the namespace around all others that it lies in; empty for the global one.
llvm::StringRef outermostNamespace(const clang::Decl& declaration);

/// Whether it lies anywhere within namespace std.
bool isStandard(const clang::Decl& declaration);

/// Whether it is std::<name>, inline namespaces left out.
bool isStandard(const clang::CXXRecordDecl& type, const char* name);

}  // namespace oroforge::cxx

#endif
