// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "deferred_libraries.hpp"

#include <algorithm>
#include <utility>

namespace RTT::plugin {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

auto isAt(const std::string& path) {
    return [&path](const DeferredLibraries::Library& library) { return library.path == path; };
}

}  // namespace

void DeferredLibraries::add(const std::string& path, std::vector<std::string> types) {
    if (!has(path)) libraries_.push_back(Library{path, std::move(types)});
}

bool DeferredLibraries::remove(const std::string& path) {
    const auto known = std::find_if(libraries_.begin(), libraries_.end(), isAt(path));
    if (known == libraries_.end()) return false;
    libraries_.erase(known);
    return true;
}

void DeferredLibraries::markFailed(const std::string& path) {
    const auto known = std::find_if(libraries_.begin(), libraries_.end(), isAt(path));
    if (known != libraries_.end()) known->failed = true;
}

bool DeferredLibraries::has(const std::string& path) const {
    return std::any_of(libraries_.begin(), libraries_.end(), isAt(path));
}

bool DeferredLibraries::hasType(const std::string& type) const {
    return std::any_of(libraries_.begin(), libraries_.end(),
                       [&](const Library& library) { return contains(library.types, type); });
}

std::vector<std::string> DeferredLibraries::with(const std::vector<std::string>& types,
                                                 const std::string& before) const {
    std::vector<std::string> paths;
    for (const Library& library : libraries_) {
        if (library.path == before) break;
        if (std::any_of(types.begin(), types.end(),
                        [&](const std::string& type) { return contains(library.types, type); }))
            paths.push_back(library.path);
    }
    return paths;
}

}  // namespace RTT::plugin
