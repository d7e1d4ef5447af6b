// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A process that opens such a file locks it and then looks whether it is still at its name (log_claim.cpp). So a file
// that this process has locked, and finds at its name, may be deleted.
#include <rtt/detail/log_leftovers.hpp>

#include <rtt/os/descriptor.hpp>

#include <algorithm>
#include <ctime>
#include <map>
#include <memory>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace RTT::detail {
namespace {

using os::detail::Descriptor;

/** A process that has just made its file may not have locked it yet. */
constexpr time_t kNewFor = 60;

struct NameParts {
    std::string folder, stem, extension;
};

NameParts partsOf(const std::string& name) {
    const std::size_t folder = name.rfind('/') + 1;  // 0 without a folder
    const std::size_t point = name.rfind('.');
    const std::size_t end = point == std::string::npos || point <= folder ? name.size() : point;
    return {name.substr(0, folder), name.substr(folder, end - folder), name.substr(end)};
}

/** Takes `part` off the beginning of `text`; false if that begins otherwise. */
bool take(std::string_view& text, std::string_view part) {
    if (text.substr(0, part.size()) != part) return false;
    text.remove_prefix(part.size());
    return true;
}
std::string_view takeDigits(std::string_view& text) {
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    const auto end = std::find_if_not(text.begin(), text.end(), isDigit);
    const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(digits.size());
    return digits;
}

/** The name without the number of an earlier file; empty if it has another form, or the id of this process. */
std::string_view processFile(std::string_view name, const NameParts& parts) {
    std::string_view rest = name;
    if (!take(rest, parts.stem) || !take(rest, "-")) return {};
    const std::string_view id = takeDigits(rest);
    if (id.empty() || id == std::to_string(getpid())) return {};
    if (take(rest, "-") && takeDigits(rest).empty()) return {};
    if (!take(rest, parts.extension)) return {};
    const std::string_view file = name.substr(0, name.size() - rest.size());
    if (take(rest, ".") && takeDigits(rest).empty()) return {};
    return rest.empty() ? file : std::string_view();
}

bool isOwn(const struct stat& file) { return S_ISREG(file.st_mode) && file.st_uid == geteuid(); }

/** Does the first line say that this file was written instead of the one of that name? See log_file.cpp. */
bool saysSo(int file, const std::string& name, const NameParts& asked) {
    char begin[4096];
    const ssize_t size = pread(file, begin, sizeof begin, 0);
    if (size <= 0) return false;
    const std::string_view all(begin, static_cast<std::size_t>(size));
    const std::string_view line = all.substr(0, all.find('\n'));
    const std::string other = asked.stem + asked.extension;
    const auto ends = [&](const std::string& text, std::size_t end) {
        if (end < text.size() || line.substr(end - text.size(), text.size()) != text) return false;
        const std::size_t at = end - text.size();
        return at > 0 && (line[at - 1] == '\'' || line[at - 1] == '/');
    };
    if (line.empty() || line.back() != '\'' || !ends(name, line.size() - 1)) return false;
    for (const std::string_view words : {"' is being written by another process; this process writes '",
                                         "' belongs to another user; this process writes '"}) {
        const std::size_t at = line.find(words);
        if (at != std::string_view::npos && ends(other, at)) return true;
    }
    return false;
}

/** A file that another process made instead of the one that was asked for. */
struct ProcessFile {
    std::string name;
    std::vector<std::string> earlier;
    struct stat status {};
};

bool isSame(const struct stat& a, const struct stat& b) { return a.st_dev == b.st_dev && a.st_ino == b.st_ino; }

/** The files of this user that have such names, the latest first. */
std::vector<ProcessFile> processFiles(DIR* folder, const NameParts& asked) {
    std::map<std::string, std::vector<std::string>, std::less<>> names;
    while (const dirent* const entry = readdir(folder)) {
        const std::string_view file = processFile(entry->d_name, asked);
        if (file.empty()) continue;
        std::vector<std::string>& earlier = names[std::string(file)];
        if (file != entry->d_name) earlier.emplace_back(entry->d_name);
    }
    std::vector<ProcessFile> files;
    for (auto& [name, earlier] : names) {
        ProcessFile file{name, std::move(earlier), {}};
        if (fstatat(dirfd(folder), name.c_str(), &file.status, AT_SYMLINK_NOFOLLOW) == 0 && isOwn(file.status))
            files.push_back(std::move(file));
    }
    std::sort(files.begin(), files.end(), [](const ProcessFile& a, const ProcessFile& b) {
        const timespec &left = a.status.st_mtim, &right = b.status.st_mtim;
        return std::tie(left.tv_sec, left.tv_nsec) > std::tie(right.tv_sec, right.tv_nsec);
    });
    return files;
}

/** The open and locked file; empty if it is to stay. */
Descriptor lockLeftover(int folder, const ProcessFile& file, const NameParts& asked) {
    Descriptor open(::openat(folder, file.name.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    struct stat status {
    }, named{};
    const bool left = open && fstat(open.get(), &status) == 0 && isSame(status, file.status) && isOwn(status) &&
                      (status.st_size == 0 ? std::time(nullptr) - status.st_mtim.tv_sec >= kNewFor
                                           : saysSo(open.get(), file.name, asked)) &&
                      flock(open.get(), LOCK_EX | LOCK_NB) == 0 &&
                      fstatat(folder, file.name.c_str(), &named, AT_SYMLINK_NOFOLLOW) == 0 && isSame(status, named);
    if (!left) open.reset();
    return open;
}

/** The file itself last: what a failure leaves is found again. */
bool remove(int folder, const ProcessFile& file) {
    for (const std::string& name : file.earlier) {
        struct stat status {};
        if (fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 && isOwn(status))
            (void)unlinkat(folder, name.c_str(), 0);
    }
    return unlinkat(folder, file.name.c_str(), 0) == 0;
}

}  // namespace

std::string ownLogName(const std::string& name, int number) {
    const NameParts parts = partsOf(name);
    return parts.folder + parts.stem + '-' + std::to_string(getpid()) +
           (number > 1 ? '-' + std::to_string(number) : "") + parts.extension;
}

std::size_t removeLogLeftovers(const std::string& name, unsigned keep) {
    const NameParts parts = partsOf(name);
    const std::unique_ptr<DIR, int (*)(DIR*)> folder(opendir(parts.folder.empty() ? "." : parts.folder.c_str()),
                                                     &closedir);
    if (!folder) return 0;
    std::size_t left = 0, removed = 0;
    for (const ProcessFile& file : processFiles(folder.get(), parts)) {
        const Descriptor locked = lockLeftover(dirfd(folder.get()), file, parts);
        if (locked && ++left > keep && remove(dirfd(folder.get()), file)) ++removed;
    }
    return removed;
}

}  // namespace RTT::detail
