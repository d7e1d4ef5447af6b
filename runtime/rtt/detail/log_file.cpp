// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/detail/log_file.hpp>

#include <rtt/detail/log_claim.hpp>
#include <rtt/os/own_file.hpp>

#include <cerrno>
#include <cstring>
#include <new>
#include <unistd.h>

namespace RTT::detail {

namespace {

constexpr const char* kOthers = "; ORO_LOGFILE names another one, /dev/null for none";

/** What the log says of the file that it got, or did not get. */
void describe(const ClaimedLog& log, const LogFileRules& rules, LogNotes& notes) {
    const std::string asked = "'" + rules.name + "'";
    const std::string held =
        asked + (log.heldBy == "another user" ? " belongs to " : " is being written by ") + log.heldBy;
    if (log.descriptor < 0) {
        const std::string which = log.heldBy.empty() ? asked : held + ", and '" + log.name + "'";
        const std::string why = log.error == EBUSY ? "other processes write it" : os::detail::openError(log.error);
        notes.emplace_back(Warning,
                           "no log file: " + which + " cannot be written: " + why + (rules.named ? "" : kOthers));
        return;
    }
    if (!log.heldBy.empty()) notes.emplace_back(Info, "log file " + held + "; this process writes '" + log.name + "'");
    if (log.rotated) notes.emplace_back(Info, "the log file of an earlier process is '" + log.name + ".1' now");
    if (log.rotateError != 0)
        notes.emplace_back(Warning, "the log file '" + log.name + "' of an earlier process cannot be renamed: " +
                                        std::strerror(log.rotateError) + "; lines are added to it");
}

}  // namespace

bool writeAll(int descriptor, const char* text, std::size_t size) noexcept {
    while (size != 0) {
        const ssize_t written = ::write(descriptor, text, size);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        text += written;
        size -= static_cast<std::size_t>(written);
    }
    return true;
}

bool LogFile::open(const LogFileRules& rules, LogNotes& notes) {
    const bool again = !name_.empty() && rules.name == rules_.name && leadsTo(name_, identity_);
    ClaimedLog log;
    if (again) log = claimLog(name_, rules.keep, &identity_);
    if (!again || log.descriptor < 0) log = claimLog(rules.name, rules.keep, nullptr);
    rules_ = rules;
    if (!again || log.name != name_ || log.rotated) describe(log, rules, notes);
    name_ = log.name;
    path_ = log.path;
    descriptor_ = log.descriptor;
    used_ = 0;
    failure_ = rotateFailure_ = 0;
    failureTaken_ = rotateFailureTaken_ = false;
    const bool known = isOpen() && fstat(descriptor_, &identity_) == 0;
    owned_ = known && !path_.empty();
    size_ = owned_ ? static_cast<std::uint64_t>(identity_.st_size) : 0;
    limit_ = rules.most;
    return isOpen();
}

int LogFile::replace() {
    if (!leadsTo(path_, identity_)) return errno = ENOENT, -1;
    if (rules_.keep == 0) return ftruncate(descriptor_, 0) == 0 ? descriptor_ : -1;
    return rotateLog(path_, descriptor_, rules_.keep);
}

void LogFile::rotate() {
    flush();
    int fresh = -1;
    try {
        fresh = replace();
    } catch (const std::bad_alloc&) {
        errno = ENOMEM;
    }
    if (fresh < 0) {
        rotateFailure_ = errno;
        limit_ = size_ + rules_.most;  // the next attempt
        return;
    }
    if (fresh != descriptor_) ::close(descriptor_);
    descriptor_ = fresh;
    (void)fstat(descriptor_, &identity_);
    size_ = 0;
    limit_ = rules_.most;
}

void LogFile::put(const char* text, std::size_t size) noexcept {
    size_ += size;
    if (!writeAll(descriptor_, text, size) && failure_ == 0) failure_ = errno != 0 ? errno : EIO;
}

std::string LogFile::takeFailure() {
    if (failure_ != 0 && !failureTaken_) {
        failureTaken_ = true;
        return std::string("the log file lacks lines that cannot be written: ") + std::strerror(failure_);
    }
    if (rotateFailure_ != 0 && !rotateFailureTaken_) {
        rotateFailureTaken_ = true;
        return "the log file has reached ORO_LOGFILE_MAX and cannot be renamed: " +
               std::string(rotateFailure_ == ENOENT ? "another process has moved it or its folder"
                                                    : std::strerror(rotateFailure_)) +
               "; it goes on growing";
    }
    return {};
}

void LogFile::write(const char* text, std::size_t size) {
    if (limit_ != 0 && owned_ && size_ + used_ != 0 && size_ + used_ + size > limit_) rotate();
    add(text, size);
}

void LogFile::add(const char* text, std::size_t size) noexcept {
    if (!isOpen()) return;
    if (size > sizeof buffer_ - used_) flush();
    if (size > sizeof buffer_) return put(text, size);
    std::memcpy(buffer_ + used_, text, size);
    used_ += size;
}

void LogFile::flush() noexcept {
    if (isOpen() && used_ != 0) put(buffer_, used_);
    used_ = 0;
}

void LogFile::close() noexcept {
    flush();
    if (isOpen()) ::close(descriptor_);
    descriptor_ = -1;
}

}  // namespace RTT::detail
