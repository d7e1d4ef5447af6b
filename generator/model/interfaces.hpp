// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Walks through everything that a package offers: components, their services, and nested services.
#ifndef OROFORGE_GENERATOR_MODEL_INTERFACES_HPP
#define OROFORGE_GENERATOR_MODEL_INTERFACES_HPP

#include <string>
#include <vector>

#include <model/package.hpp>

namespace oroforge::model {

/// Names of services from the component inwards; empty for the component's own interface.
using ServicePath = std::vector<std::string>;

/// Calls visit(interface, path) for `top` and all services in it, outer ones first.
template <class Visit>
void eachInterface(const Interface& top, const Visit& visit, const ServicePath& path = {}) {
    visit(top, path);
    for (const Service& service : top.services) {
        ServicePath inner = path;
        inner.push_back(service.name.value);
        eachInterface(service, visit, inner);
    }
}

/// Does the same for all components and services of a package.
template <class Visit>
void eachInterface(const Package& package, const Visit& visit) {
    for (const Component& component : package.components) eachInterface(component, visit);
    for (const ServicePlugin& service : package.services) eachInterface(service, visit);
}

}  // namespace oroforge::model

#endif
