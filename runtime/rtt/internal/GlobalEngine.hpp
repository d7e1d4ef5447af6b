// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_GLOBAL_ENGINE_HPP
#define ORO_GLOBAL_ENGINE_HPP

#include <rtt/rtt-config.h>

namespace RTT {
class ExecutionEngine;
namespace internal {

/** The engine for those who are no component: caller of their operations, and executor of sent operations that are for the
    client's thread. Its thread is started with the first use. Thread safe. */
class RTT_API GlobalEngine {
public:
    static ExecutionEngine* Instance();
    /** Stops its thread; the next Instance() starts it anew. */
    static void Release();
};

}  // namespace internal
}  // namespace RTT

#endif
