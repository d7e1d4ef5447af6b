// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Which adapter is meant for a class.
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
    std::map<std::string, std::string> cpp;    ///< what the variables stand for in C++ …
    std::map<std::string, std::string> names;  ///< … and in the type registry, without a leading '/'
};

/// What that name means in C++: a number or text, a class, an enum or an alias; nothing, and the nearest name that there is.
std::optional<clang::QualType> typeCalled(const std::string& name, clang::ASTContext& context, std::string& nearest);

class AdapterFinder {
public:
    AdapterFinder(const std::vector<adapters::Adapter>& all, const clang::ASTContext& context, diag::Sink& sink);

    /// The first that fits; nothing if there is none.
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
