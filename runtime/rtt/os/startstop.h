// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_STARTSTOP_H
#define ORO_OS_STARTSTOP_H

#include <rtt/rtt-config.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Starts the runtime: stores the arguments, registers the main thread, reserves real-time memory (oro_malloc.h), starts
 * logging and loads plugins. ORO_main calls it. Returns 0, or the result of a start function that failed. A second call
 * changes only the stored arguments.
 */
RTT_API int __os_init(int argc, char** argv);

/** Stops what __os_init() started. Stop and destroy your components first. */
RTT_API void __os_exit(void);

/** The arguments given to __os_init(); 0 and null before. The strings are not copied. */
RTT_API int __os_main_argc(void);
RTT_API char** __os_main_argv(void);

#ifdef __cplusplus
}
#endif
#endif
