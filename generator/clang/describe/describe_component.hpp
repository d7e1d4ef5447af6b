// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Describes a component or service class as a model.
#ifndef OROFORGE_GENERATOR_CLANG_DESCRIBE_DESCRIBE_COMPONENT_HPP
#define OROFORGE_GENERATOR_CLANG_DESCRIBE_DESCRIBE_COMPONENT_HPP

#include <set>
#include <string>

#include <diag/sink.hpp>
#include <model/package.hpp>

#include "component_state.hpp"
#include "find_components.hpp"
#include "typekit_headers.hpp"

namespace oroforge::cxx {

class ComponentDescriber {
public:
    /// `root` is the folder of the package.
    ComponentDescriber(clang::Sema& sema, const SourcePlaces& places, const std::string& root, diag::Sink& remarks)
        : sema_(sema), places_(places), remarks_(remarks), typekit_(sema.getSourceManager(), places, root) {}

    model::Component component(const clang::CXXRecordDecl& type);
    model::ServicePlugin service(const FoundClass& found);

    /// Returns the headers with the types that others see in the described classes.
    std::vector<model::Text> typekitHeaders() const { return typekit_.headers(remarks_); }

    /// Returns files that declare functions without known definitions.
    const std::set<std::string>& incomplete() const { return incomplete_; }

private:
    /// Follows the constructor; reports what other functions of the class add later.
    Followed follow(const clang::CXXRecordDecl& type);
    model::Text nameOf(const clang::CXXRecordDecl& type) const;
    std::string docOf(const clang::CXXRecordDecl& type) const;

    clang::Sema& sema_;
    const SourcePlaces& places_;
    diag::Sink& remarks_;
    TypekitHeaders typekit_;
    std::set<std::string> incomplete_;
};

}  // namespace oroforge::cxx

#endif
