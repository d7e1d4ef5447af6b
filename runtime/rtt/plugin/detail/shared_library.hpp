// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// One loaded shared library, closed again unless kept.
#ifndef OROFORGE_PLUGIN_SHARED_LIBRARY_HPP
#define OROFORGE_PLUGIN_SHARED_LIBRARY_HPP

#include <initializer_list>
#include <string>
#include <vector>

namespace RTT::plugin {

class SharedLibrary {
public:
    enum Scope { Local, Global };

    SharedLibrary() = default;
    /**
     * Opens the file and resolves all symbols. What it is linked with and the linker does not find is loaded before (loadNeeded()).
     * On failure the object is false and `error` says why.
     */
    SharedLibrary(const std::string& file, Scope scope, std::string& error);
    SharedLibrary(SharedLibrary&& other) noexcept;
    SharedLibrary& operator=(SharedLibrary&& other) noexcept;
    ~SharedLibrary();

    explicit operator bool() const { return handle_ != nullptr; }

    /**
     * A function that this very library defines, null if it has none of that name. The linker's own look-up would go
     * on in the libraries it depends on, and a component library that links another would pass for it.
     */
    template <class Function>
    Function* function(const char* name) const {
        return reinterpret_cast<Function*>(ownSymbol(name));
    }

    /** The function or object at this address belongs to this very library. */
    bool holds(const void* address) const;

    /** What the library says it was compiled for, if that is not what this program was compiled for; else empty. */
    std::string otherVersion() const;

    /** Leaves the library loaded for the rest of the process. */
    void keep() { handle_ = nullptr; }

    /** True if the process has the file loaded, whoever asked for it. */
    static bool isLoaded(const std::string& file);
    /** The file that the function or object at this address was loaded from, as its opener named it; empty if unknown. */
    static std::string fileWith(const void* address);
    /** The files of libraries that the program is linked with, so that they were loaded with it, and define a symbol. */
    static std::vector<std::string> linkedThatDefine(std::initializer_list<const char*> symbols);

private:
    explicit SharedLibrary(void* handle) : handle_(handle) {}
    bool tryOpen(const std::string& path, Scope scope, std::string& error);
    void* ownSymbol(const char* name) const;

    void* handle_ = nullptr;
};

}  // namespace RTT::plugin

#endif
