/* SPDX-License-Identifier: Apache-2.0 */
/* Copyright Oroforge contributors */
#ifndef OROFORGE_TESTS_SUPPORT_REAL_TIME_HOOKS_H
#define OROFORGE_TESTS_SUPPORT_REAL_TIME_HOOKS_H

/* Between the trap and the functions that stand in front of libc's. */
#ifdef __cplusplus
extern "C" {
#endif

/* 1 if the functions below are those that everybody calls, 0 if a sanitizer has its own. */
int oroforge_real_time_hooks_present(void);
/* Told of every call, with a bit of RealTimeTrap::Kind and the place the function returns to. */
void oroforge_real_time_note(unsigned kind, const char* function, const void* caller);

#ifdef __cplusplus
}
#endif
#endif
