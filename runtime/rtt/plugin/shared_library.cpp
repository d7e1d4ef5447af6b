// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "shared_library.hpp"

#include <rtt/plugin/detail/needed_library.hpp>
#include <rtt/plugin/detail/trusted_file.hpp>

#include <rtt/os/descriptor.hpp>
#include <rtt/plugin/version_guard.hpp>

#include <dlfcn.h>
#include <fcntl.h>
#include <link.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>

namespace RTT::plugin {
namespace {

/** The files of all libraries in the process, in the order of loading; the program itself is left out. */
std::vector<std::string> loadedFiles() {
    std::vector<std::string> files;
    const auto add = [](dl_phdr_info* info, std::size_t, void* to) {
        static_cast<std::vector<std::string>*>(to)->emplace_back(info->dlpi_name);
        return 0;
    };
    dl_iterate_phdr(add, &files);
    return files;
}

/** The library that has the address; null if unknown. Unlike dladdr(), this does not read all symbols of the
    library. */
const link_map* ownerOf(const void* address) {
    dl_find_object found;
    return _dl_find_object(const_cast<void*>(address), &found) == 0 ? found.dlfo_link_map : nullptr;
}

/** The number of libraries when this one was initialised: those that were loaded with the program. */
const std::size_t loadedWithProgram = loadedFiles().size();

/** The size that the headers of the open file claim; 0 if they are malformed, in which case the linker refuses the
    file. */
std::uint64_t expectedSize(int file) {
    ElfW(Ehdr) head;
    if (pread(file, &head, sizeof head, 0) != sizeof head || std::memcmp(head.e_ident, ELFMAG, SELFMAG) != 0 ||
        head.e_phentsize != sizeof(ElfW(Phdr)))
        return 0;
    std::uint64_t size = head.e_phoff + std::uint64_t{head.e_phnum} * sizeof(ElfW(Phdr));
    for (unsigned i = 0; i < head.e_phnum; ++i) {
        ElfW(Phdr) segment;
        if (pread(file, &segment, sizeof segment, static_cast<off_t>(head.e_phoff + i * sizeof segment)) !=
            sizeof segment)
            return size;
        if (segment.p_type == PT_LOAD) size = std::max<std::uint64_t>(size, segment.p_offset + segment.p_filesz);
    }
    return size;
}

bool isArchive(int file) {
    const char magic[] = {'!', '<', 'a', 'r', 'c', 'h', '>', '\n'};
    char begin[sizeof magic];
    return pread(file, begin, sizeof begin, 0) == sizeof begin && std::memcmp(begin, magic, sizeof magic) == 0;
}

/** Why the linker must not open the file: a truncated library would crash it, and on an archive its message is
    obscure. */
std::string whyUnusable(const std::string& path) {
    const os::detail::Descriptor opened(open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!opened) return std::string();  // the linker says why
    const int file = opened.get();
    const bool archive = isArchive(file);
    struct stat status;
    const std::uint64_t size = fstat(file, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
    const std::uint64_t expected = expectedSize(file);
    if (archive) return "it is a static library, which can only be linked into a program";
    if (size >= expected) return std::string();
    return "the file is cut short: it has " + std::to_string(size) + " bytes, expected " + std::to_string(expected);
}

}  // namespace

SharedLibrary::SharedLibrary(const std::string& file, Scope scope, std::string& error) {
    // Without a slash the linker would search its own path instead of opening this file.
    const std::string path = file.find('/') == std::string::npos ? "./" + file : file;
    error = whyNotTrusted(path);
    if (error.empty()) error = whyUnusable(path);
    if (!error.empty()) return;
    std::string lastNeeded;
    while (!tryOpen(path, scope, error)) {
        const std::string needed = notFoundLibrary(error, path);
        // If it was loaded and is still not found, its soname is not its file name.
        if (needed.empty() || needed == lastNeeded || !loadNeeded(needed, error)) return;
        lastNeeded = needed;
    }
}

bool SharedLibrary::tryOpen(const std::string& path, Scope scope, std::string& error) {
    handle_ = dlopen(path.c_str(), RTLD_NOW | (scope == Global ? RTLD_GLOBAL : RTLD_LOCAL));
    const char* text = handle_ ? "" : dlerror();
    error = text ? text : "unknown reason";
    // The caller's message names the file.
    if (error.compare(0, path.size() + 2, path + ": ") == 0) error.erase(0, path.size() + 2);
    return handle_ != nullptr;
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
    return symbol && holds(symbol) ? symbol : nullptr;
}

bool SharedLibrary::holds(const void* address) const {
    link_map* self = nullptr;
    return dlinfo(handle_, RTLD_DI_LINKMAP, &self) == 0 && ownerOf(address) == self;
}

std::string SharedLibrary::otherVersion() const {
    auto* builtFor = function<const char*()>("getRTTBuiltFor");
    const std::string version = builtFor ? builtFor() : ORO_BUILT_FOR;
    return version == ORO_BUILT_FOR ? std::string() : version;
}

bool SharedLibrary::isLoaded(const std::string& file) {
    void* handle = dlopen(file.c_str(), RTLD_LAZY | RTLD_NOLOAD);
    if (handle) dlclose(handle);
    return handle != nullptr;
}

std::string SharedLibrary::fileWith(const void* address) {
    if (const link_map* const owner = ownerOf(address); owner && *owner->l_name) return owner->l_name;
    Dl_info info;  // also has the name with which the program was called
    return dladdr(address, &info) && info.dli_fname ? info.dli_fname : std::string();
}

std::vector<std::string> SharedLibrary::linkedThatDefine(std::initializer_list<const char*> symbols) {
    std::vector<std::string> files = loadedFiles();
    files.resize(std::min(files.size(), loadedWithProgram));
    const auto lacksAll = [&](const std::string& file) {
        const SharedLibrary library(file.empty() ? nullptr : dlopen(file.c_str(), RTLD_LAZY | RTLD_NOLOAD));
        return !library || std::none_of(symbols.begin(), symbols.end(),
                                        [&](const char* symbol) { return library.ownSymbol(symbol) != nullptr; });
    };
    files.erase(std::remove_if(files.begin(), files.end(), lacksAll), files.end());
    return files;
}

}  // namespace RTT::plugin
