// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// To be included first: what follows it is compiled with the checker's atomics, mutexes, shared pointers and sleeping in
// place of the standard ones, by renaming them. So the runtime's own sources are tested, not copies of them.
// Standard and Boost headers must all be read before the names change.
#ifndef OROFORGE_MODEL_SUBSTITUTE_HPP
#define OROFORGE_MODEL_SUBSTITUTE_HPP

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cerrno>
#include <chrono>
#include <climits>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <cxxabi.h>
#include <deque>
#include <exception>
#include <functional>
#include <iostream>
#include <linux/futex.h>
#include <linux/membarrier.h>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <pthread.h>
#include <semaphore.h>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <sys/syscall.h>
#include <thread>
#include <type_traits>
#include <typeinfo>
#include <unistd.h>
#include <utility>
#include <vector>

#include <boost/function.hpp>
#include <boost/shared_ptr.hpp>
#include <boost/smart_ptr/intrusive_ptr.hpp>

#include <model/checker/atomic.hpp>
#include <model/checker/checker.hpp>
#include <model/checker/shared_pointer.hpp>

namespace std {
template <class T>
using model_atomic = ::model::Atomic<T>;
using model_mutex = ::model::Mutex;
template <class T>
using model_shared_ptr = ::model::SharedPointer<T>;
using ::model::makeShared;
namespace model_this_thread {
template <class Time>
void sleep_for(const Time&) {
    ::model::yield();
}
inline void yield() { ::model::yield(); }
}  // namespace model_this_thread
}  // namespace std

namespace model {
/** Stands for syscall(2): of all system calls, the code under test makes membarrier only. */
inline long systemCall(long number, int command, int, int) {
    if (number == SYS_membarrier && command == MEMBARRIER_CMD_PRIVATE_EXPEDITED) membarrier();
    return 0;
}
}  // namespace model

#define atomic model_atomic
#define mutex model_mutex
#define this_thread model_this_thread
#define syscall ::model::systemCall
#ifdef MODEL_SHARED_POINTERS  // not where boost's are used as well
#define shared_ptr model_shared_ptr
#define make_shared makeShared
#endif

#endif
