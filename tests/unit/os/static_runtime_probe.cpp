// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/os/startstop.h>

#include <cstdio>

/** Program that startstop_test runs: its runtime ends after the objects that starting it made. */
struct Runtime {
    ~Runtime() {
        __os_exit();
        std::puts("ended");
    }
} runtime;

int main() {
    static char name[] = "probe";
    static char* words[] = {name, nullptr};
    __os_init(1, words);
    RTT::ComponentLoader::Instance();
}
