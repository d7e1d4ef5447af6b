/* SPDX-License-Identifier: Apache-2.0 */
/* Copyright Oroforge contributors */
/* Clocks of the computer, which tell something else in each replay. The clocks of C++ use these. */
#include "in_front.h"

#include <sys/time.h>
#include <sys/timeb.h>
#include <time.h>

OROFORGE_WATCH(CLOCK, int, clock_gettime, (clockid_t c, struct timespec* to), (c, to))
OROFORGE_WATCH(CLOCK, int, gettimeofday, (struct timeval* restrict to, void* restrict zone), (to, zone))
OROFORGE_WATCH(CLOCK, time_t, time, (time_t* to), (to))
OROFORGE_WATCH(CLOCK, clock_t, clock, (void), ())
OROFORGE_WATCH(CLOCK, int, timespec_get, (struct timespec* to, int base), (to, base))
