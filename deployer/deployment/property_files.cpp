// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "property_files.hpp"

#include <ctime>

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

const PropertyFile& PropertyFiles::current(const std::string& path, bool wantsErrors, diag::Sink& sink) {
    struct stat status {};
    (void)stat(path.c_str(), &status);  // before reading, so that a change meanwhile is noticed
    // Not the time of modification, which programs that copy files set back.
    const timespec& changed = status.st_ctim;
    const Stamp stamp{status.st_dev, status.st_ino, status.st_size, changed.tv_sec, changed.tv_nsec};
    Entry& entry = entries_[path];
    const bool isKnown = entry.file && entry.isSettled && entry.stamp == stamp && (entry.file->isGood || !wantsErrors);
    if (!isKnown) entry = {stamp, isSettled(changed), std::make_unique<const PropertyFile>(path, sink)};
    return *entry.file;
}

const PropertyFile* PropertyFiles::read(const std::string& path, diag::Sink& sink) {
    const PropertyFile& file = current(path, /*wantsErrors=*/true, sink);
    return file.isGood ? &file : nullptr;
}

const PropertyFile* PropertyFiles::readAgain(const std::string& path) {
    diag::Sink reported;
    const PropertyFile& file = current(path, /*wantsErrors=*/false, reported);
    return file.isGood ? &file : nullptr;
}

}  // namespace OCL::deploy
