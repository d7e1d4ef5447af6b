// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds types that are different without the macro __orogen; code that uses them does not define it.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_HIDDEN_FIELDS_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_HIDDEN_FIELDS_HPP

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <diag/sink.hpp>
#include <model/type_model.hpp>

#include "find_roots.hpp"

namespace oroforge::cxx {

struct Layout {
    std::uint64_t size = 0;
    std::vector<std::pair<std::string, std::uint64_t>> fields;  ///< own fields, with their offsets in bits
};

/// Layouts by C++ name, of all structs defined in the listed headers, suitable or not.
using Layouts = std::map<std::string, Layout>;
Layouts layoutsOf(const clang::ASTContext& context, const std::vector<Root>& roots);

/// Sets `uses` if a header tests __orogen or __orogen2.
void watchForMacro(clang::Preprocessor& preprocessor, bool& uses);

/// Warns of each type that is different without the macro.
void compareLayouts(const model::TypeModel& described, const Layouts& with, const Layouts& without, diag::Sink& sink);

}  // namespace oroforge::cxx

#endif
