// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Reads C++ headers with clang: all of them in one parse, without function bodies.
///
///     headers ─► one main file that includes them ─► clang AST ─► find_roots ─► describe_type ─► TypeModel
///                                                                     └─ classify, names, comments ─┘
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_TYPE_READER_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_TYPE_READER_HPP

#include <optional>
#include <string>
#include <vector>

#include <adapters/adapter.hpp>
#include <diag/sink.hpp>
#include <model/type_model.hpp>

namespace oroforge::cxx {

struct ParseRequest {
    std::vector<model::Header> headers;
    std::vector<std::string> flags;   ///< -I -isystem -D -U -include -std, each word one element
    std::string target = "gnulinux";  ///< value of the macro OROCOS_TARGET
    std::string resourceDir;          ///< clang's own headers; empty = look for them
    std::vector<adapters::Adapter> adapters;
    bool strict = false;  ///< a class that is not a value is an error, even if nothing requests it
};

/// Returns structs and enums defined in the listed headers, and all types that they use, in no particular order; the
/// caller adds library types and arrays. Returns nothing after an error; all errors are in the sink.
std::optional<model::TypeModel> readTypes(const ParseRequest& request, diag::Sink& sink);

}  // namespace oroforge::cxx

#endif
