// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Which headers of a package typegen has to read, so that the types of its ports, properties and operations are known.
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
    /// `root`: folder of the package.
    TypekitHeaders(const clang::SourceManager& sources, const SourcePlaces& places, const std::string& root);

    /// Its file is no input of typegen: it defines a component or a service.
    void addComponent(const clang::CXXRecordDecl& type);
    /// A type that others see, with the types that it is made of.
    void addUse(clang::QualType type);

    /// Relative to the package, sorted. A type of the package that no header has for itself is a remark.
    std::vector<model::Text> headers(diag::Sink& remarks) const;

private:
    /// Of a file of the package: its name there. Empty if it is somebody else's.
    std::string fileOf(const clang::Decl& type) const;

    const clang::SourceManager& sources_;
    const SourcePlaces& places_;
    std::string root_;
    std::set<std::string> components_;  ///< files
    std::vector<const clang::TagDecl*> types_;
};

}  // namespace oroforge::cxx

#endif
