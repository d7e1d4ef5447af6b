// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "property_files.hpp"

#include <ctime>
#include <utility>

#include <sys/stat.h>

namespace OCL::deploy {

using RTT::marsh::PropertyFile;

namespace {

/** Two changes within one tick of the clock that stamps files have the same time. The tick of the kernel is at most 10
    ms; some file systems count whole seconds, FAT two of them. */
bool isSettled(const timespec& changed) {
    timespec now{};
    (void)clock_gettime(CLOCK_REALTIME, &now);
    const double age =
        static_cast<double>(now.tv_sec - changed.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec - changed.tv_nsec);
    return age > (changed.tv_nsec == 0 ? 3 : 0.02);
}

}  // namespace

PropertyFiles::Entry& PropertyFiles::current(const std::string& path, bool wantsErrors) {
    struct stat status {};
    (void)stat(path.c_str(), &status);  // before reading, so that a change meanwhile is noticed
    // Not the time of modification, which programs that copy files set back.
    const timespec& changed = status.st_ctim;
    const Stamp stamp{status.st_dev, status.st_ino, status.st_size, changed.tv_sec, changed.tv_nsec};
    Entry& entry = entries_[path];
    const bool isKnown = entry.file && entry.isSettled && entry.stamp == stamp && (entry.file->isGood || !wantsErrors);
    if (isKnown) return entry;
    diag::Sink found;
    auto file = std::make_unique<const PropertyFile>(path, found);
    return entry = {stamp, isSettled(changed), std::move(file), std::move(found)};
}

const PropertyFile* PropertyFiles::read(const std::string& path, diag::Sink& sink) {
    Entry& entry = current(path, /*wantsErrors=*/true);
    for (const diag::Diagnostic& one : entry.unreported.all()) sink.add(one);
    entry.unreported = {};
    return entry.file->isGood ? entry.file.get() : nullptr;
}

const PropertyFile* PropertyFiles::readAgain(const std::string& path) {
    const Entry& entry = current(path, /*wantsErrors=*/false);
    return entry.file->isGood ? entry.file.get() : nullptr;
}

}  // namespace OCL::deploy
