// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Program that runtime_bench measures: starts the runtime and prints its resident memory in bytes, before and after.
#include <rtt/os/startstop.h>
#include <rtt/types/Types.hpp>

#include <cstdio>

namespace {

long residentBytes() {
    long kib = 0;
    if (std::FILE* file = std::fopen("/proc/self/status", "r")) {
        char line[256];
        while (std::fgets(line, sizeof line, file) && std::sscanf(line, "VmRSS: %ld kB", &kib) != 1) {
        }
        std::fclose(file);
    }
    return kib * 1024;
}

}  // namespace

int main(int argc, char** argv) {
    const long before = residentBytes();
    __os_init(argc, argv);
    if (!RTT::types::Types()->type("double")) return 1;  // its typekit was not found
    std::printf("%ld %ld\n", before, residentBytes());
    __os_exit();
}
