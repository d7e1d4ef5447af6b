// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <emit/transaction.hpp>

#include <cerrno>

#include <sys/stat.h>

#include <files/draft_file.hpp>

namespace fs = std::filesystem;

namespace oroforge::emit {

namespace {

/// Files below /dev belong to the system, even a link to a regular file: they are written to, not replaced.
bool isWrittenTo(const fs::path& target, const struct stat& is) {
    return !S_ISREG(is.st_mode) || target.parent_path() == "/dev";
}

bool stands(const fs::path& target) {
    struct stat is {};
    return ::lstat(target.c_str(), &is) == 0;
}

}  // namespace

Transaction::~Transaction() {
    if (!done_) rollBack();
}

bool Transaction::makeDirectories(const fs::path& directory) {
    std::error_code error, other;
    if (directory.empty() || fs::is_directory(directory, error)) return true;
    if (!makeDirectories(directory.parent_path())) return false;
    if (fs::create_directory(directory, error)) {
        directories_.push_back(directory);
        return true;
    }
    // Another process may have made it first.
    return fs::is_directory(directory, other) || fail(directory, "cannot make the directory", error);
}

bool Transaction::stage(const fs::path& target, const std::string& text) {
    struct stat before {};
    const bool exists = ::stat(target.c_str(), &before) == 0;
    if (exists && S_ISDIR(before.st_mode)) return fail(target, "found a directory, expected a file or nothing", {});
    if (exists && isWrittenTo(target, before)) {
        direct_.push_back({target, text});
        return true;
    }
    if (!makeDirectories(target.parent_path())) return false;
    std::string draft;
    const int descriptor = files::openDraft(target.string(), draft);
    if (descriptor < 0) return fail(target, "cannot write the file", {errno, std::generic_category()});
    staged_.push_back({target, draft, {}});
    const std::error_code kept = exists ? files::takeOver(descriptor, before) : std::error_code();
    const std::error_code written = files::writeAndClose(descriptor, text, files::Durability::process);
    if (!kept && !written) return true;
    return fail(target, "cannot write the file", written ? written : kept);
}

bool Transaction::replace(Staged& file) {
    std::error_code error;
    // The old file gets a second name, so that the target never disappears, even for a moment.
    if (stands(file.target)) error = files::keepBackup(file.target.string(), file.backup);
    if (error) return fail(file.target, "cannot replace the file", error);
    fs::rename(file.draft, file.target, error);
    if (error) return fail(file.target, "cannot write the file", error);
    file.draft.clear();
    return true;
}

bool Transaction::commit() {
    for (const Direct& file : direct_) {
        if (const auto error = files::overwrite(file.target.string(), file.text))
            return fail(file.target, "cannot write the file", error);
    }
    for (Staged& file : staged_)
        if (!replace(file)) return false;
    for (const Staged& file : staged_) {
        std::error_code ignored;
        if (!file.backup.empty()) fs::remove(file.backup, ignored);
    }
    done_ = true;
    return true;
}

bool Transaction::fail(const fs::path& path, const std::string& what, const std::error_code& error) {
    sink_.error({path.string(), 0, 0}, "EMIT001", error ? what + ": " + error.message() : what);
    return false;
}

void Transaction::rollBack() {
    std::error_code ignored;
    for (const Staged& file : staged_) {
        // A remaining draft means that the target was not touched.
        if (file.draft.empty()) {
            if (file.backup.empty())
                fs::remove(file.target, ignored);
            else
                fs::rename(file.backup, file.target, ignored);
        } else {
            fs::remove(file.draft, ignored);
            if (!file.backup.empty()) fs::remove(file.backup, ignored);
        }
    }
    for (auto it = directories_.rbegin(); it != directories_.rend(); ++it) fs::remove(*it, ignored);
}

}  // namespace oroforge::emit
