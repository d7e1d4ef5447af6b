// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "real_time_memory.hpp"

#include <rtt/os/tlsf/tlsf.h>

#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <iostream>

#include <linux/capability.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace OCL::deploy {

std::size_t parseMemorySize(const std::string& text) {
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    static const std::string kUnits = "kmg";
    double unit = 1;
    if (*end != '\0') {
        const std::size_t power = kUnits.find(static_cast<char>(std::tolower(static_cast<unsigned char>(*end))));
        if (power == std::string::npos || end[1] != '\0') return 0;
        unit = static_cast<double>(std::size_t(1024) << (10 * power));
    }
    const double bytes = number * unit;
    // Written so that NaN fails, too.
    return bytes >= 1 && bytes < 1e15 ? static_cast<std::size_t>(bytes) : 0;
}

std::string setRealTimeMemoryAside(std::size_t size) {
    void* const memory = std::malloc(size);
    if (!memory) return "the system does not give " + std::to_string(size) + " bytes for real-time memory";
    std::memset(memory, 0, size);  // touched now, so that no real-time thread has a page fault
    const std::size_t free = init_memory_pool(size, memory);
    if (free == 0) {
        std::free(memory);
        return std::to_string(size) + " bytes are too few for real-time memory";
    }
    std::cout << "Real-time memory: " << free << " bytes free of " << size << std::endl;
    return {};
}

namespace {

bool mayLockAnything() {
    rlimit limit{};
    if (getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY) return true;
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    __user_cap_data_struct data[_LINUX_CAPABILITY_U32S_3] = {};
    if (syscall(SYS_capget, &header, data) != 0) return false;
    return (data[CAP_TO_INDEX(CAP_IPC_LOCK)].effective & CAP_TO_MASK(CAP_IPC_LOCK)) != 0;
}

}  // namespace

std::string lockMemory() {
    static const std::string kNot = "--lock-memory: the memory is not locked: ";
    static const std::string kCure =
        "; allow it by a line '<user or @group> - memlock unlimited' in a file in /etc/security/limits.d, and log in "
        "again (systemd: LimitMEMLOCK=infinity, docker: --ulimit memlock=-1)";
    // With a limit, locking might succeed now, but memory for a thread or component would be refused later.
    if (!mayLockAnything()) return kNot + "the memlock limit of this user is not 'unlimited'" + kCure;
    if (mlockall(MCL_CURRENT | MCL_FUTURE) == 0) return {};
    return kNot + std::strerror(errno) + (errno == EPERM ? kCure : "");
}

void reportRealTimeMemory() {
    std::cout << "Real-time memory: " << get_used_size_mp() << " bytes in use at the end, " << get_max_size_mp()
              << " at most, of these " << get_overhead_size_mp() << " for bookkeeping" << std::endl;
}

}  // namespace OCL::deploy
