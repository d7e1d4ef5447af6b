// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Which classes are components or services.
#ifndef OROFORGE_GENERATOR_CLANG_DESCRIBE_FIND_COMPONENTS_HPP
#define OROFORGE_GENERATOR_CLANG_DESCRIBE_FIND_COMPONENTS_HPP

#include <string>
#include <vector>

#include <clang/base/source_places.hpp>
#include <diag/sink.hpp>
#include <model/package.hpp>

namespace oroforge::cxx {

struct FoundClass {
    const clang::CXXRecordDecl* type = nullptr;
    std::string service;  ///< of a service class: the name of its plugin
};

struct FoundClasses {
    std::vector<FoundClass> components;
    std::vector<FoundClass> services;
    std::vector<model::Plugin> plugins;
    std::vector<const clang::CXXRecordDecl*> unregistered;  ///< components left out, because others are registered
};

/// In the order of their definitions. Registered classes (ORO_CREATE_COMPONENT, ORO_LIST_COMPONENT_TYPE) if there are any,
/// else all components that can be made and whose class or constructor is defined in the listed files; services if they are plugins. Plugins of
/// kinds that a manifest has no words for are remarks.
FoundClasses findComponents(clang::Sema& sema, const SourcePlaces& places, diag::Sink& remarks);

/// Whether it is RTT::TaskContext, RTT::Service … or derived from it.
bool isDerivedFrom(const clang::CXXRecordDecl& type, const char* name);

/// The constructor that a component loader would call, else the first that is no copy; null if there is none.
const clang::CXXConstructorDecl* constructorOf(const clang::CXXRecordDecl& type, clang::Sema& sema);

/// With namespaces, those without a name left out.
std::string classNameOf(const clang::CXXRecordDecl& type);

}  // namespace oroforge::cxx

#endif
