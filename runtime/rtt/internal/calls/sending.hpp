// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_SENDING_HPP
#define ORO_INTERNAL_SENDING_HPP

#include <rtt/rtt-config.h>
#include <rtt/base/DisposableInterface.hpp>

namespace RTT {
namespace internal {

class CalleeBase;
class SentCall;

/** Announces a call that this thread is about to send, to a watcher that learns how it ends. */
struct RTT_API Sending {
    /** Must exist until the call was sent, or another one is announced. */
    class RTT_API Watcher {
    public:
        virtual ~Watcher();
        /** The object to queue instead of the call, whose reference it takes over and which it executes or disposes. */
        virtual base::DisposableInterface* queued(SentCall& call) = 0;
    };

    const CalleeBase* callee = nullptr;
    Watcher* watcher = nullptr;

    /** Has the next call of `next.callee` that this thread queues watched; a null watcher ends that. Real-time safe. */
    static void announce(Sending next) noexcept;
    /** For code that queues a call of `callee`: the watcher, once per announcement; null if none. Real-time safe. */
    static Watcher* take(const CalleeBase* callee) noexcept;
};

// Initial-exec: a real-time thread reads it with each call that it sends, and must not allocate then.
inline thread_local Sending announced __attribute__((tls_model("initial-exec")));

inline Sending::Watcher* Sending::take(const CalleeBase* callee) noexcept {
    if (!announced.watcher || announced.callee != callee) return nullptr;
    Watcher* const watcher = announced.watcher;
    announced = Sending();
    return watcher;
}

}  // namespace internal
}  // namespace RTT

#endif
