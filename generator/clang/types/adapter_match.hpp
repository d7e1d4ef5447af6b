// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds the adapter for a class.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_ADAPTER_MATCH_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_ADAPTER_MATCH_HPP

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <adapters/adapter.hpp>
#include <clang/base/llvm_compat.hpp>
#include <diag/sink.hpp>

namespace oroforge::cxx {

struct AdapterMatch {
    const adapters::Adapter* adapter;
    std::map<std::string, std::string> cpp;    ///< C++ for the variables
    std::map<std::string, std::string> names;  ///< the same in the type registry, without a leading '/'
};

/// Returns the C++ type of that name: a number, text, class, enum or alias; nothing, and the nearest known name.
std::optional<clang::QualType> typeCalled(const std::string& name, clang::ASTContext& context, std::string& nearest);

class AdapterFinder {
public:
    AdapterFinder(const std::vector<adapters::Adapter>& all, const clang::ASTContext& context, diag::Sink& sink);

    /// Returns the first adapter that fits; nothing if there is none.
    std::optional<AdapterMatch> find(const clang::CXXRecordDecl& type) const;

private:
    struct Entry {
        const adapters::Adapter* adapter;
        const clang::Decl* declaration;  // the canonical class or class template
    };
    std::vector<Entry> entries_;
};

}  // namespace oroforge::cxx

#endif
