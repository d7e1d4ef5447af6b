// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds the headers of a package that typegen must read for the types of its ports, properties and operations.
#ifndef OROFORGE_GENERATOR_CLANG_DESCRIBE_TYPEKIT_HEADERS_HPP
#define OROFORGE_GENERATOR_CLANG_DESCRIBE_TYPEKIT_HEADERS_HPP

#include <set>
#include <string>
#include <vector>

#include <clang/base/source_places.hpp>
#include <diag/sink.hpp>
#include <model/package.hpp>

namespace oroforge::cxx {

class TypekitHeaders {
public:
    /// `root` is the folder of the package.
    TypekitHeaders(const clang::SourceManager& sources, const SourcePlaces& places, const std::string& root);

    /// Excludes the file, because it defines a component or a service.
    void addComponent(const clang::CXXRecordDecl& type);
    /// Adds a type that others see, and the types it is made of.
    void addUse(clang::QualType type);

    /// Returns headers relative to the package, sorted. A type of the package without a header of its own is a remark.
    std::vector<model::Text> headers(diag::Sink& remarks) const;

private:
    /// Returns the name of a file in the package; empty for other files.
    std::string fileOf(const clang::Decl& type) const;

    const clang::SourceManager& sources_;
    const SourcePlaces& places_;
    std::string root_;
    std::set<std::string> components_;  ///< files
    std::vector<const clang::TagDecl*> types_;
};

}  // namespace oroforge::cxx

#endif
