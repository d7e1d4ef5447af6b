// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "property_files.hpp"

#include <sys/stat.h>

namespace OCL::deploy {

using RTT::marsh::PropertyFile;

bool PropertyFiles::Stamp::operator==(const Stamp& other) const {
    return device == other.device && inode == other.inode && size == other.size &&
           changed.tv_sec == other.changed.tv_sec && changed.tv_nsec == other.changed.tv_nsec;
}

PropertyFiles::Stamp PropertyFiles::stampOf(const std::string& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) return {};
    // Not the time of modification, which programs that copy files set back.
    return {status.st_dev, status.st_ino, status.st_size, status.st_ctim};
}

/** Two changes within one tick of the clock that stamps files have the same time. The tick of the kernel is at most 10
    ms; some file systems count whole seconds, FAT two of them. */
bool PropertyFiles::isSettled(const Stamp& stamp) {
    timespec now{};
    (void)clock_gettime(CLOCK_REALTIME, &now);
    const double age = static_cast<double>(now.tv_sec - stamp.changed.tv_sec) +
                       1e-9 * static_cast<double>(now.tv_nsec - stamp.changed.tv_nsec);
    return age > (stamp.changed.tv_nsec == 0 ? 3 : 0.02);
}

const PropertyFile& PropertyFiles::current(const std::string& path, bool wantsErrors, diag::Sink& sink) {
    const Stamp stamp = stampOf(path);  // before reading, so that a change meanwhile is noticed
    Entry& entry = entries_[path];
    const bool isKnown = entry.file && entry.isSettled && entry.stamp == stamp && (entry.file->isGood || !wantsErrors);
    if (!isKnown) entry = {stamp, isSettled(stamp), std::make_unique<const PropertyFile>(path, sink)};
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
