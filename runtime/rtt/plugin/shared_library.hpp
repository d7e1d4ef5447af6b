// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A loaded shared library, which is closed again unless kept.
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
     * Opens the file and resolves all symbols. First loads needed libraries that the linker does not find
     * (loadNeeded()). On failure the object is false and `error` says why.
     */
    SharedLibrary(const std::string& file, Scope scope, std::string& error);
    SharedLibrary(SharedLibrary&& other) noexcept;
    SharedLibrary& operator=(SharedLibrary&& other) noexcept;
    ~SharedLibrary();

    explicit operator bool() const { return handle_ != nullptr; }

    /**
     * A function that this library itself defines; null if it has none of that name. The linker's look-up would also
     * search the libraries on which it depends, so a library that links a component library would be taken for it.
     */
    template <class Function>
    Function* function(const char* name) const {
        return reinterpret_cast<Function*>(ownSymbol(name));
    }

    /** True if the function or object at this address belongs to this library itself. */
    bool holds(const void* address) const;

    /** What the library was compiled for, if the program was compiled for something else; otherwise empty. */
    std::string otherVersion() const;

    /** Leaves the library loaded for the rest of the process. */
    void keep() { handle_ = nullptr; }

    /** True if the file is loaded into the process, by this loader or another. */
    static bool isLoaded(const std::string& file);
    /** The file from which the function or object at this address was loaded, as named when opened; empty if
        unknown. */
    static std::string fileWith(const void* address);
    /** The files of libraries that are linked with the program and define one of these symbols. */
    static std::vector<std::string> linkedThatDefine(std::initializer_list<const char*> symbols);

private:
    explicit SharedLibrary(void* handle) : handle_(handle) {}
    bool tryOpen(const std::string& path, Scope scope, std::string& error);
    void* ownSymbol(const char* name) const;

    void* handle_ = nullptr;
};

}  // namespace RTT::plugin

#endif
