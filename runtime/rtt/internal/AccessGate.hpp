// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_ACCESS_GATE_HPP
#define ORO_INTERNAL_ACCESS_GATE_HPP

#include <rtt/rtt-config.h>

#include <atomic>
#include <cstdint>
#include <memory>

namespace RTT {
namespace internal {

/**
 * Stands between an object and those who keep a plain pointer to it. They take a Pass before they use the object; its
 * destructor closes the gate, which waits for those inside and lets nobody in any more. The object and its users
 * share the gate, so it outlives both.
 *
 * One word holds the number of users inside and, in its highest bit, whether the gate is closed. A Pass and close() each
 * change it in one atomic operation, so one of the two comes first: either the user finds the bit and leaves the object
 * alone, or close() finds the user and waits. The default (sequentially consistent) order is used; the part that matters
 * is that what users did to the object happens before close() returns.
 */
class RTT_API AccessGate {
public:
    /** Inside as long as it lives, if the gate was open. Lives on the stack; may be nested. Real-time safe. */
    class RTT_API Pass {
    public:
        /** A null gate is closed. */
        explicit Pass(const std::shared_ptr<AccessGate>& gate) noexcept;
        ~Pass();
        Pass(const Pass&) = delete;
        Pass& operator=(const Pass&) = delete;
        explicit operator bool() const noexcept { return gate_ != nullptr; }

    private:
        friend class AccessGate;
        std::shared_ptr<AccessGate> gate_;  // shared: user and object may both be destroyed while it lives
        const Pass* outer_ = nullptr;       // of this thread
    };

    /** Blocks until nobody is inside, except this thread: an object may be destroyed by what its user makes it do. */
    void close() noexcept;
    /** Real-time safe. */
    void open() noexcept { word_.fetch_and(~kClosed); }

private:
    static constexpr std::uint32_t kClosed = 0x80000000u;
    bool enter() noexcept;
    void leave() noexcept;

    std::atomic<std::uint32_t> word_{0};
};

}  // namespace internal
}  // namespace RTT
#endif
