// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_GLOBAL_ENGINE_HPP
#define ORO_GLOBAL_ENGINE_HPP

#include <rtt/rtt-config.h>

namespace RTT {
class ExecutionEngine;
namespace internal {

/** The engine of threads that are not a component's: the caller of their operations, and the executor of sent
    operations that run in the client's thread. The first use starts its thread. Thread safe. */
class RTT_API GlobalEngine {
public:
    /** Always the same engine. Real-time safe, except for the first use and the first after Release(). */
    static ExecutionEngine* Instance();
    /** Ends its thread, and refuses calls meanwhile; the next Instance() starts it anew. Blocks until the message in
        progress ends. Does nothing in its own thread, or while another thread is in Release(). */
    static void Release();
};

}  // namespace internal
}  // namespace RTT

#endif
