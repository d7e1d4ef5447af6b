// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_MAIN_H
#define ORO_OS_MAIN_H

/**
 * @file
 * Write `int ORO_main(int argc, char** argv) { … }` instead of main(): the runtime is started before and stopped after
 * it, and exceptions that leave it are reported. Option `--nocatch` lets them pass, for a debugger.
 */
#include <rtt/os/startstop.h>

#ifdef __cplusplus
extern "C" {
#endif
/** Runs `body` between __os_init() and __os_exit(). Returns its result, −1 if it threw, or the error of __os_init(). */
RTT_API int __os_run_main(int argc, char** argv, int (*body)(int, char**));
#ifdef __cplusplus
}
#endif

// Continues the `int` that precedes the macro: declaration of the body, main(), definition of the body.
#define ORO_main(...)                                                                     \
    ORO_main_impl(int, char**);                                                           \
    int main(int argc, char** argv) { return __os_run_main(argc, argv, &ORO_main_impl); } \
    int ORO_main_impl(__VA_ARGS__)

#endif
