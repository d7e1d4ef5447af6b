// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_ACCESS_GATE_HPP
#define ORO_INTERNAL_ACCESS_GATE_HPP

#include <rtt/internal/engine/presence.hpp>

#include <atomic>
#include <memory>

namespace RTT {
namespace internal {

/**
 * Protects an object that others reach by a plain pointer. A user takes a Pass before it uses the object; the object's
 * destructor closes the gate, which waits for the threads inside and lets no further one in. The object and its users
 * share the gate, so it outlives both.
 *
 * A Pass enters and then looks whether the gate is closed, see Presence.
 */
class RTT_API AccessGate {
public:
    /** Inside as long as it lives, if the gate was open. Lives on the stack; may be nested. Real-time safe. */
    class RTT_API Pass {
    public:
        /** A null gate is closed. */
        explicit Pass(const std::shared_ptr<AccessGate>& gate) noexcept : place_(gate ? enter(*gate) : nullptr) {}
        ~Pass() {
            if (place_) Presence::leave(*place_);  // the gate may be gone by now
        }
        Pass(const Pass&) = delete;
        Pass& operator=(const Pass&) = delete;
        explicit operator bool() const noexcept { return place_ != nullptr; }

    private:
        static Presence::Place* enter(const AccessGate& gate) noexcept {
            Presence::Place& place = Presence::enter(&gate);
            if (!gate.closed_) return &place;
            Presence::leave(place);
            return nullptr;
        }
        Presence::Place* const place_;
    };

    /** Call it before others get the gate; without it close() does not wait. Real-time safe. */
    void share() noexcept { shared_ = true; }
    /** Blocks until no other thread is inside. This one may be: a user of the object may cause its destruction. */
    void close() noexcept;
    /** The same for a gate that will not be opened again: it may be destroyed while this thread is inside. */
    void closeForGood() noexcept;
    /** Real-time safe. */
    void open() noexcept { closed_ = false; }

private:
    std::atomic<bool> closed_{false}, shared_{false};
};

}  // namespace internal
}  // namespace RTT
#endif
