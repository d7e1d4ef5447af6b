// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Component libraries that are loaded when one of their types is needed.
#ifndef OROFORGE_DEFERRED_LIBRARIES_HPP
#define OROFORGE_DEFERRED_LIBRARIES_HPP

#include <string>
#include <vector>

namespace RTT::plugin {

/** In the order in which they were found: of two with a type of the same name, the first one has it. Not
    thread-safe. */
class DeferredLibraries {
public:
    struct Library {
        std::string path;  // canonical
        std::vector<std::string> types;
        bool failed = false;  // an attempt to load it failed
    };

    /** Ignores a library that is there already. */
    void add(const std::string& path, std::vector<std::string> types);
    /** True if it was there. */
    bool remove(const std::string& path);
    void markFailed(const std::string& path);

    bool has(const std::string& path) const;
    bool hasType(const std::string& type) const;
    const std::vector<Library>& all() const { return libraries_; }
    /** The paths of libraries that have one of the types. With `before`, only of those found before that one. */
    std::vector<std::string> with(const std::vector<std::string>& types, const std::string& before) const;

private:
    std::vector<Library> libraries_;
};

}  // namespace RTT::plugin

#endif
