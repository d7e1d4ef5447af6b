// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's: no two threads take functions out of an inactive component here.
#ifndef OROFORGE_MODEL_ENGINE_MUTEX_LOCK_HPP
#define OROFORGE_MODEL_ENGINE_MUTEX_LOCK_HPP

namespace RTT {
namespace os {

struct Mutex {
    ~Mutex() {}
};

struct MutexLock {
    explicit MutexLock(Mutex&) {}
    ~MutexLock() {}
};

}  // namespace os
}  // namespace RTT

#endif
