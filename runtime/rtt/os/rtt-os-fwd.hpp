// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Forward declarations of the operating system layer.
#ifndef ORO_RTT_OS_FWD_HPP
#define ORO_RTT_OS_FWD_HPP

namespace RTT {
namespace os {
class AtomicInt;
class CleanupFunction;
class Condition;
class InitFunction;
class MainThread;
class Mutex;
class MutexInterface;
class MutexLock;
class MutexRecursive;
class MutexTimedLock;
class MutexTryLock;
class Semaphore;
class SharedMutex;
class StartStopManager;
class Thread;
class ThreadInterface;
class TimeService;
class Timer;
template <class T>
class rt_allocator;
}  // namespace os
}  // namespace RTT

#endif
