// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Files that are written beside another one, and take its place when they are complete.
#ifndef OROFORGE_FILES_DRAFT_FILE_HPP
#define OROFORGE_FILES_DRAFT_FILE_HPP

#include <filesystem>
#include <set>
#include <string>
#include <system_error>

struct stat;

namespace oroforge::files {

enum class Durability {
    process,  ///< complete if the process crashes
    machine,  ///< also if the machine does: the disk is waited for
};

/// Opens a new file beside `target` and sets its name, "<target>.<process id>.<number>.new". Nothing that stands there,
/// links included, is opened, followed or removed. -1 and errno if it cannot be made.
int openDraft(const std::string& target, std::string& name);

/// Keeps what `target` has under a second name of the same form, ending in ".old", and sets that: as a hard link, or as
/// a copy where none can be made. After an error the caller removes what has the name.
std::error_code keepBackup(const std::string& target, std::string& name);

/// Gives the file the owner, group and permissions of `before`, as far as this process may set them.
std::error_code takeOver(int descriptor, const struct stat& before);

/// Writes everything, and closes in any case.
std::error_code writeAndClose(int descriptor, const std::string& text, Durability durability);

/// Writes over what stands there; the file must exist. For devices, pipes, and files that cannot be replaced.
std::error_code overwrite(const std::string& file, const std::string& text);

/// Removes drafts and backups of the files `names` in `folder` that processes of this user left behind when they died.
/// A process of another container that shares the folder counts as dead.
void removeAbandoned(const std::filesystem::path& folder, const std::set<std::string>& names);

}  // namespace oroforge::files

#endif
