// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "report_file.hpp"

#include <cerrno>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace OCL::reporting {

std::string systemError() { return std::generic_category().message(errno); }

bool isRegular(int file) {
    struct stat status {};
    return ::fstat(file, &status) == 0 && S_ISREG(status.st_mode);
}

std::string claim(int file) {
    // Two reports in a file would destroy each other's rows. File systems without locks do not show that.
    if (::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return "another reporter is writing to it";
    return ::ftruncate(file, 0) == 0 ? std::string() : systemError();
}

}  // namespace OCL::reporting
