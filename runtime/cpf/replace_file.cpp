// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "replace_file.hpp"

#include <cerrno>
#include <cstdio>
#include <files/draft_file.hpp>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

namespace RTT::marsh {

namespace fs = std::filesystem;
namespace files = oroforge::files;

namespace {

std::error_code lastError() { return {errno, std::generic_category()}; }

/** The target of a symbolic link, whether or not it exists. */
fs::path followed(fs::path path) {
    std::error_code failed;
    for (int links = 0; links != 40 && fs::is_symlink(path, failed); ++links) {
        const fs::path next = fs::read_symlink(path, failed);
        if (failed) break;
        path = next.is_absolute() ? next : path.parent_path() / next;
    }
    return path;
}

/** True if this error, of creating a file beside the target or of renaming it, may come of a target that can be
    overwritten. */
bool mayOverwriteAfter(const std::error_code& failed) {
    switch (failed.value()) {
        case EACCES:
        case EPERM:
        case EROFS:
        case EBUSY:
        case EXDEV: return true;
        default: return false;
    }
}

/** `before` is null if there is no such file yet. */
std::error_code replaceBy(const std::string& target, const std::string& text, const struct stat* before) {
    const fs::path path = target;
    files::removeAbandoned(path.parent_path(), {path.filename().string()});
    std::string beside;
    const int descriptor = files::openDraft(target, beside);
    if (descriptor < 0) return lastError();
    std::error_code failed = before ? files::takeOver(descriptor, *before) : std::error_code();
    const std::error_code written = files::writeAndClose(descriptor, text, files::Durability::machine);
    if (!failed) failed = written;
    if (!failed && std::rename(beside.c_str(), target.c_str()) != 0) failed = lastError();
    if (failed) ::unlink(beside.c_str());
    return failed;
}

}  // namespace

std::error_code replaceFile(const std::string& file, const std::string& text) {
    const std::string target = followed(file).string();
    struct stat before {};
    const bool exists = ::stat(target.c_str(), &before) == 0;
    if (!exists && errno != ENOENT) return lastError();
    if (exists && !S_ISREG(before.st_mode)) return files::overwrite(target, text);
    if (exists && ::access(target.c_str(), W_OK) != 0) return lastError();

    const std::error_code failed = replaceBy(target, text, exists ? &before : nullptr);
    return exists && mayOverwriteAfter(failed) ? files::overwrite(target, text) : failed;
}

}  // namespace RTT::marsh
