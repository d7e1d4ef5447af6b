// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_PROPERTY_FILES_HPP
#define OROFORGE_DEPLOYMENT_PROPERTY_FILES_HPP

#include <cpf/property_file.hpp>

#include <map>
#include <memory>
#include <string>
#include <tuple>

#include <sys/types.h>

namespace OCL::deploy {

namespace diag = oroforge::diag;

/**
 * The property files of a deployment, each read once: what is checked, before and after components exist, is also what
 * is applied. A file is read again if it has changed, because scripts and hooks that run between check and use may
 * write it.
 */
class PropertyFiles {
public:
    /** The file, valid until its next use; null if it has errors. Reports warnings when the file is read, errors each
        time. */
    const RTT::marsh::PropertyFile* read(const std::string& path, diag::Sink& sink);
    /** As read(), but reports nothing: that was done before, or the next read() does it. */
    const RTT::marsh::PropertyFile* readAgain(const std::string& path);
    /** Frees all files. */
    void clear() { entries_.clear(); }

private:
    /** Device, inode, size, seconds and nanoseconds: what changes if a file is written or replaced. */
    using Stamp = std::tuple<dev_t, ino_t, off_t, time_t, long>;
    struct Entry {
        Stamp stamp;
        bool isSettled = false;  // a later change has another stamp
        std::unique_ptr<const RTT::marsh::PropertyFile> file;
        diag::Sink unreported;  // warnings
    };

    Entry& current(const std::string& path, bool wantsErrors);

    std::map<std::string, Entry> entries_;  // by path
};

}  // namespace OCL::deploy

#endif
