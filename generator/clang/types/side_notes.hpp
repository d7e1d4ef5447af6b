// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What a user who asks (--verbose) is told though nothing is wrong: types that differ between machines, templates that
/// nobody uses.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_SIDE_NOTES_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_SIDE_NOTES_HPP

#include <string>
#include <vector>

#include <clang/base/llvm_compat.hpp>
#include <clang/base/source_places.hpp>
#include <diag/diagnostic.hpp>
#include <model/type_model.hpp>

namespace oroforge::cxx {

/// Empty, or why values of the field mean something else on another machine: "is 'wchar_t', …".
std::string portabilityOf(const clang::FieldDecl& field);

/// Class templates and specialisations in the listed headers of which no type was described.
std::vector<diag::Note> unusedTemplates(const clang::ASTContext& context, const SourcePlaces& places,
                                        const model::TypeModel& described);

}  // namespace oroforge::cxx

#endif
