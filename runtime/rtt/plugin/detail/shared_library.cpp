// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "shared_library.hpp"

#include <dlfcn.h>
#include <link.h>

#include <utility>

namespace RTT::plugin {

SharedLibrary::SharedLibrary(const std::string& file, Scope scope, std::string& error) {
    // Without a slash the linker would search its own path instead of opening this file.
    const std::string path = file.find('/') == std::string::npos ? "./" + file : file;
    handle_ = dlopen(path.c_str(), RTLD_NOW | (scope == Global ? RTLD_GLOBAL : RTLD_LOCAL));
    if (!handle_) {
        const char* text = dlerror();
        error = text ? text : "unknown reason";
        // Who reports it names the file anyway.
        if (error.compare(0, path.size() + 2, path + ": ") == 0) error.erase(0, path.size() + 2);
    }
}

SharedLibrary::SharedLibrary(SharedLibrary&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}

SharedLibrary& SharedLibrary::operator=(SharedLibrary&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
}

SharedLibrary::~SharedLibrary() {
    if (handle_) dlclose(handle_);
}

void* SharedLibrary::ownSymbol(const char* name) const {
    void* symbol = dlsym(handle_, name);
    Dl_info info;
    link_map* owner = nullptr;
    link_map* self = nullptr;
    if (!symbol || !dladdr1(symbol, &info, reinterpret_cast<void**>(&owner), RTLD_DL_LINKMAP) ||
        dlinfo(handle_, RTLD_DI_LINKMAP, &self) != 0)
        return nullptr;
    return owner == self ? symbol : nullptr;
}

}  // namespace RTT::plugin
