// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds component and service classes.
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
    std::string service;  ///< name of the plugin of a service class
};

struct FoundClasses {
    std::vector<FoundClass> components;
    std::vector<FoundClass> services;
    std::vector<model::Plugin> plugins;
    std::vector<const clang::CXXRecordDecl*> unregistered;  ///< components left out because others are registered
};

/// Returns classes in the order of their definitions: registered ones (ORO_CREATE_COMPONENT, ORO_LIST_COMPONENT_TYPE)
/// or, if there are none, all components that can be made and whose class or constructor is defined in the listed
/// files; services if they are plugins. Plugins of kinds that a manifest cannot describe are remarks.
FoundClasses findComponents(clang::Sema& sema, const SourcePlaces& places, diag::Sink& remarks);

/// True for RTT::TaskContext, RTT::Service … and classes derived from it.
bool isDerivedFrom(const clang::CXXRecordDecl& type, const char* name);

/// Returns the constructor that a component loader calls, else the first that does not copy; null if there is none.
const clang::CXXConstructorDecl* constructorOf(const clang::CXXRecordDecl& type, clang::Sema& sema);

/// Returns the name with its namespaces, except unnamed ones.
std::string classNameOf(const clang::CXXRecordDecl& type);

}  // namespace oroforge::cxx

#endif
