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

/** What a thread is about to send, for somebody who wants to know how it ends. */
struct RTT_API Sending {
    /** Lives until the call was sent, or another one is announced. */
    class RTT_API Watcher {
    public:
        virtual ~Watcher();
        /** What is queued instead of the call, whose reference it takes over: it has to execute it, or to dispose it. */
        virtual base::DisposableInterface* queued(SentCall& call) = 0;
    };

    const CalleeBase* callee = nullptr;
    Watcher* watcher = nullptr;

    /** The next call of that function that this thread queues is watched; null: none. Real-time safe. */
    static void announce(Sending next) noexcept;
    /** For whoever queues a call of the function: once for each announcement; null if nobody watches. Real-time safe. */
    static Watcher* take(const CalleeBase* callee) noexcept;
};

// Initial-exec: a real-time thread asks for it with each call that it sends, and must not allocate then.
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
