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
    /** Always the same engine. Real-time safe, except for the first use and the first after Release(). */
    static ExecutionEngine* Instance();
    /** Ends its thread, and refuses calls meanwhile; the next Instance() starts it anew. Blocks until what is being executed
        ends. Does nothing in its own thread, or while another thread is in here. */
    static void Release();
};

}  // namespace internal
}  // namespace RTT

#endif
