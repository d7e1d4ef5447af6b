// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_ACCESS_GATE_HPP
#define ORO_INTERNAL_ACCESS_GATE_HPP

#include <rtt/internal/Presence.hpp>

#include <atomic>
#include <memory>

namespace RTT {
namespace internal {

/**
 * Stands between an object and those who keep a plain pointer to it. They take a Pass before they use the object; its
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
            if (place_) Presence::leave(*place_);  // of a gate that may be gone
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

    /** To be called before others get the gate. Without that there is nobody for whom close() would wait. Real-time safe. */
    void share() noexcept { shared_ = true; }
    /** Blocks until nobody is inside, except this thread: an object may be destroyed by what its user makes it do. */
    void close() noexcept;
    /** The same when it will not be opened again: it may be destroyed while this thread is inside. */
    void closeForGood() noexcept;
    /** Real-time safe. */
    void open() noexcept { closed_ = false; }

private:
    std::atomic<bool> closed_{false}, shared_{false};
};

}  // namespace internal
}  // namespace RTT
#endif
