// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "trusted_file.hpp"

#include <rtt/plugin/search_path.hpp>

#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace RTT::plugin {
namespace {

constexpr const char* kOwners = "ORO_TRUSTED_OWNERS";
constexpr std::size_t kEntrySize = 16384;  // of the user database; a group's has all its members

std::string nameOf(uid_t user) {
    passwd entry, *found = nullptr;
    std::vector<char> text(kEntrySize);
    return getpwuid_r(user, &entry, text.data(), text.size(), &found) == 0 && found ? found->pw_name
                                                                                    : std::to_string(user);
}

bool isNamed(uid_t user) {
    const char* const text = std::getenv(kOwners);
    if (!text || !*text) return false;
    const std::string list = text, number = std::to_string(user), name = nameOf(user);
    for (std::size_t begin = 0; begin <= list.size();) {
        const std::size_t end = std::min(list.find_first_of(" ,:", begin), list.size());
        const std::string word = list.substr(begin, end - begin);
        if (word == number || word == name) return true;
        begin = end + 1;
    }
    return false;
}

/** True if this is the user who called `sudo`: a process of root trusts that user. */
bool isOfSudo(uid_t user) {
    const char* const caller = std::getenv("SUDO_UID");
    return geteuid() == 0 && caller && std::to_string(user) == caller;
}

bool isTrusted(uid_t user) { return user == 0 || user == geteuid() || isOfSudo(user) || isNamed(user); }

/** True if only the owner is in the group, as where each user has a group of the same name. */
bool isPrivate(gid_t group, uid_t owner) {
    if (group == 0) return true;
    struct group entry, *found = nullptr;
    std::vector<char> text(kEntrySize);
    if (getgrgid_r(group, &entry, text.data(), text.size(), &found) != 0 || !found) return group == owner;
    const std::string name = nameOf(owner);
    if (name != found->gr_name) return false;
    for (char** member = found->gr_mem; *member; ++member)
        if (name != *member) return false;
    return true;
}

/** True if anybody but the owner may write. */
bool othersWrite(const struct stat& status) {
    return (status.st_mode & S_IWOTH) != 0 ||
           ((status.st_mode & S_IWGRP) != 0 && !isPrivate(status.st_gid, status.st_uid));
}

std::string advice(uid_t owner) {
    return "; if that is as it should be, set " + std::string(kOwners) + "=" + nameOf(owner);
}

/** Checks the folders above that of the file. In a folder with the sticky bit, others cannot move what is not
    theirs. */
std::string whyFoldersAbove(const std::string& folder) {
    std::string below = folder;
    for (std::string above = parentPath(below); below != "/"; below = above, above = parentPath(above)) {
        struct stat status, child;
        if (stat(above.c_str(), &status) != 0 || !othersWrite(status)) continue;
        if ((status.st_mode & S_ISVTX) != 0 && lstat(below.c_str(), &child) == 0 && isTrusted(child.st_uid)) continue;
        return "other users can put another folder in the place of " + below + ": they can write to " + above +
               " (chmod o-w, or g-w)";
    }
    return {};
}

std::string whyFolder(const std::string& folder) {
    struct stat status;
    if (stat(folder.c_str(), &status) != 0) return {};
    if (!isTrusted(status.st_uid))
        return "its folder " + folder + " belongs to " + nameOf(status.st_uid) + advice(status.st_uid);
    if (othersWrite(status)) return "other users can write to its folder " + folder + " (chmod o-w, or g-w)";
    return whyFoldersAbove(folder);
}

}  // namespace

std::string whyNotTrusted(const std::string& path) {
    const std::string real = canonicalPath(path), given = absolutePath(path);
    struct stat status;
    if (stat(real.c_str(), &status) != 0) return {};
    std::string why;
    if (!isTrusted(status.st_uid))
        why = "it belongs to " + nameOf(status.st_uid) + advice(status.st_uid);
    else if (othersWrite(status))
        why = "other users can write to it (chmod o-w, or g-w)";
    if (why.empty()) why = whyFolder(parentPath(real));
    // A user who may put a link there chooses what is loaded.
    if (why.empty() && given != real) why = whyFolder(parentPath(given));
    return why.empty() ? why : "it is not trusted: " + why;
}

}  // namespace RTT::plugin
