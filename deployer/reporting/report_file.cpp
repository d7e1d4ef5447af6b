// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "report_file.hpp"

#include <rtt/os/own_file.hpp>

#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace OCL::reporting {
namespace {

// Two seconds.
constexpr int kTries = 40;
constexpr std::chrono::milliseconds kPause{50};

bool isPipe(const std::string& name) {
    struct stat status {};
    return ::stat(name.c_str(), &status) == 0 && S_ISFIFO(status.st_mode);
}

}  // namespace

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

int openReport(const std::string& name, std::string& error) {
    // Without O_NONBLOCK, opening a pipe would block start() until somebody reads from it.
    constexpr int kFlags = O_WRONLY | O_CREAT | O_APPEND | O_NONBLOCK;
    int file = RTT::os::detail::openOwnFile(name.c_str(), kFlags);
    // The reader may just be starting.
    for (int times = 0; file < 0 && errno == ENXIO && isPipe(name) && times != kTries; ++times) {
        std::this_thread::sleep_for(kPause);
        file = RTT::os::detail::openOwnFile(name.c_str(), kFlags);
    }
    if (file < 0) {
        error = errno == ENXIO && isPipe(name) ? "nobody reads from this pipe" : RTT::os::detail::openError(errno);
        return -1;
    }
    (void)::fcntl(file, F_SETFL, O_APPEND);  // writes wait for the reader
    if (!isRegular(file)) return file;
    error = claim(file);
    if (error.empty()) return file;
    ::close(file);
    return -1;
}

}  // namespace OCL::reporting
