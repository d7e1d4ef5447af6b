// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Notes for --verbose, which report no fault: types that differ between machines, and unused templates.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_SIDE_NOTES_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_SIDE_NOTES_HPP

#include <string>
#include <vector>

#include <clang/base/llvm_compat.hpp>
#include <clang/base/source_places.hpp>
#include <diag/diagnostic.hpp>
#include <model/type_model.hpp>

namespace oroforge::cxx {

/// Returns why values of the field differ on another machine, as "is 'wchar_t', …"; else empty.
std::string portabilityOf(const clang::FieldDecl& field);

/// Returns class templates and specialisations in the listed headers without any described type.
std::vector<diag::Note> unusedTemplates(const clang::ASTContext& context, const SourcePlaces& places,
                                        const model::TypeModel& described);

}  // namespace oroforge::cxx

#endif
