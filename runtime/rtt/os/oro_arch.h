// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ARCH_H
#define ORO_ARCH_H

/**
 * @file
 * Atomic integer operations with C linkage types. All are sequentially consistent and real-time safe.
 */
typedef struct {
    int cnt;
} oro_atomic_t;

#define ORO_ATOMIC_SETUP(a, n) oro_atomic_set((a), (n))
#define ORO_ATOMIC_CLEANUP(a) ((void)(a))

static inline int oro_atomic_read(const oro_atomic_t* a) { return __atomic_load_n(&a->cnt, __ATOMIC_SEQ_CST); }
static inline void oro_atomic_set(oro_atomic_t* a, int n) { __atomic_store_n(&a->cnt, n, __ATOMIC_SEQ_CST); }
static inline void oro_atomic_add(oro_atomic_t* a, int n) { __atomic_add_fetch(&a->cnt, n, __ATOMIC_SEQ_CST); }
static inline void oro_atomic_sub(oro_atomic_t* a, int n) { __atomic_sub_fetch(&a->cnt, n, __ATOMIC_SEQ_CST); }
static inline void oro_atomic_inc(oro_atomic_t* a) { oro_atomic_add(a, 1); }
static inline void oro_atomic_dec(oro_atomic_t* a) { oro_atomic_sub(a, 1); }
/** These return non-zero if the result is zero. */
static inline int oro_atomic_sub_and_test(int n, oro_atomic_t* a) {
    return __atomic_sub_fetch(&a->cnt, n, __ATOMIC_SEQ_CST) == 0;
}
static inline int oro_atomic_inc_and_test(oro_atomic_t* a) {
    return __atomic_add_fetch(&a->cnt, 1, __ATOMIC_SEQ_CST) == 0;
}
static inline int oro_atomic_dec_and_test(oro_atomic_t* a) { return oro_atomic_sub_and_test(1, a); }

#endif
