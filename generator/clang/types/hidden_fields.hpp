// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Types that look otherwise where the macro __orogen is not defined, which is where they are used.
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
    std::vector<std::pair<std::string, std::uint64_t>> fields;  ///< own ones, with their offsets in bits
};

/// By C++ name, of all structs that are defined in the listed headers, whether they can be described or not.
using Layouts = std::map<std::string, Layout>;
Layouts layoutsOf(const clang::ASTContext& context, const std::vector<Root>& roots);

/// Sets `uses` if a header asks for __orogen or __orogen2.
void watchForMacro(clang::Preprocessor& preprocessor, bool& uses);

/// Warns of each type that is different without the macro.
void compareLayouts(const model::TypeModel& described, const Layouts& with, const Layouts& without, diag::Sink& sink);

}  // namespace oroforge::cxx

#endif
