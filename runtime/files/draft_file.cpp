// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <files/draft_file.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <optional>
#include <string_view>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace oroforge::files {

namespace {

constexpr int kAttempts = 100;

std::error_code lastError() { return {errno, std::generic_category()}; }

/// Each call gives another one.
std::string nameBeside(const std::string& target, const char* ending) {
    static std::atomic<unsigned> count{0};
    return target + '.' + std::to_string(::getpid()) + '.' + std::to_string(count++) + ending;
}

/// A new file beside the target, and its name.
int openBeside(const std::string& target, const char* ending, std::string& name) {
    for (int attempts = 0; attempts != kAttempts; ++attempts) {
        name = nameBeside(target, ending);
        const int descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (descriptor >= 0 || errno != EEXIST) return descriptor;
    }
    return -1;
}

std::error_code copyBeside(const std::string& target, std::string& name) {
    struct stat before {};
    std::FILE* in = std::fopen(target.c_str(), "rbe");
    if (in == nullptr) return lastError();
    std::string text;
    std::array<char, 4096> block;
    for (std::size_t count = 0; (count = std::fread(block.data(), 1, block.size(), in)) != 0;)
        text.append(block.data(), count);
    std::error_code failed =
        std::ferror(in) != 0 || ::fstat(fileno(in), &before) != 0 ? lastError() : std::error_code();
    (void)std::fclose(in);
    if (failed) return failed;
    const int descriptor = openBeside(target, ".old", name);
    if (descriptor < 0) return lastError();
    failed = takeOver(descriptor, before);
    const std::error_code written = writeAndClose(descriptor, text, Durability::process);
    return failed ? failed : written;
}

/// A number without sign, and nothing else.
std::optional<int> numberOf(std::string_view text) {
    if (text.empty() || text.front() == '-') return std::nullopt;
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return number;
}

/// The target and the process of "x.cpf.123.0.new", or of ".old".
std::optional<std::pair<std::string, pid_t>> draftOf(const std::string& file) {
    const std::size_t ending = file.rfind('.');
    if (ending == std::string::npos || (file.substr(ending) != ".new" && file.substr(ending) != ".old"))
        return std::nullopt;
    const std::size_t count = ending == 0 ? std::string::npos : file.rfind('.', ending - 1);
    const std::size_t process =
        count == 0 || count == std::string::npos ? std::string::npos : file.rfind('.', count - 1);
    if (process == std::string::npos || process == 0) return std::nullopt;
    const std::string_view text = file;
    const auto id = numberOf(text.substr(process + 1, count - process - 1));
    if (!id || *id <= 0 || !numberOf(text.substr(count + 1, ending - count - 1))) return std::nullopt;
    return std::pair(file.substr(0, process), *id);
}

bool isDead(pid_t process) { return ::kill(process, 0) != 0 && errno == ESRCH; }

}  // namespace

int openDraft(const std::string& target, std::string& name) { return openBeside(target, ".new", name); }

std::error_code keepBackup(const std::string& target, std::string& name) {
    for (int attempts = 0; attempts != kAttempts; ++attempts) {
        name = nameBeside(target, ".old");
        if (::linkat(AT_FDCWD, target.c_str(), AT_FDCWD, name.c_str(), 0) == 0) return {};
        if (errno != EEXIST) return copyBeside(target, name);
    }
    return lastError();
}

std::error_code takeOver(int descriptor, const struct stat& before) {
    mode_t kept = 07777;
    if (::fchown(descriptor, before.st_uid, before.st_gid) != 0)
        kept = ::fchown(descriptor, static_cast<uid_t>(-1), before.st_gid) == 0 ? 02777 : 0777;
    // Last, because a change of owner clears some permissions.
    return ::fchmod(descriptor, before.st_mode & kept) == 0 ? std::error_code() : lastError();
}

std::error_code writeAndClose(int descriptor, const std::string& text, Durability durability) {
    std::error_code failed;
    for (std::size_t done = 0; done != text.size() && !failed;) {
        const ssize_t count = ::write(descriptor, text.data() + done, text.size() - done);
        if (count >= 0)
            done += static_cast<std::size_t>(count);
        else if (errno != EINTR)
            failed = lastError();
    }
    if (!failed && durability == Durability::machine && ::fsync(descriptor) != 0) failed = lastError();
    if (::close(descriptor) != 0 && !failed) failed = lastError();
    return failed;
}

std::error_code overwrite(const std::string& file, const std::string& text) {
    // Not created: for a new file the system may refuse what it allows for an old one, in a sticky folder.
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
    return descriptor < 0 ? lastError() : writeAndClose(descriptor, text, Durability::process);
}

void removeAbandoned(const fs::path& folder, const std::set<std::string>& names) {
    std::error_code error;
    std::set<fs::path> found;
    for (fs::directory_iterator it(folder.empty() ? fs::path(".") : folder, error), end; !error && it != end;
         it.increment(error)) {
        const auto draft = draftOf(it->path().filename().string());
        if (draft && names.count(draft->first) != 0 && isDead(draft->second)) found.insert(it->path());
    }
    for (const fs::path& file : found) {
        struct stat is {};
        if (::lstat(file.c_str(), &is) == 0 && S_ISREG(is.st_mode) && is.st_uid == ::geteuid()) ::unlink(file.c_str());
    }
}

}  // namespace oroforge::files
