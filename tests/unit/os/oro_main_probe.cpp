// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/main.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

/** Program that startstop_test runs. */
int ORO_main(int argc, char** argv) {
    std::printf("argc %d\n", argc);
    std::fflush(stdout);
    const std::string what = argc > 1 ? argv[1] : "";
    if (what == "throw") throw std::runtime_error("boom");
    if (what == "throwInt") throw 42;
    return argc > 2 ? std::atoi(argv[2]) : 0;
}
