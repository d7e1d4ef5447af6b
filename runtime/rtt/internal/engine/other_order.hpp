// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_OTHER_ORDER_HPP
#define ORO_INTERNAL_OTHER_ORDER_HPP

#include <rtt/rtt-config.h>

#include <boost/shared_ptr.hpp>

#include <cstdint>
#include <string>

namespace RTT {
namespace base {
class ActivityInterface;
}
namespace internal {

/**
 * Executes the components of this process in an order of its own, in one thread, instead of their activities: a replay.
 * It exchanges the activities that components get while it is installed, and has the threads that wait for each other's
 * components execute them.
 */
class RTT_API OtherOrder {
public:
    virtual ~OtherOrder();

    /** What the component gets instead of `given`, which is null for a default activity. Never null. */
    virtual boost::shared_ptr<base::ActivityInterface> replace(boost::shared_ptr<base::ActivityInterface> given,
                                                               const std::string& component) = 0;
    /** Executes a component that something has triggered; false if there is none. In its own thread. */
    virtual bool executeOne() = 0;

    /** From now on, and in this thread. Null: no longer. Call it while no other thread makes components. */
    static void install(OtherOrder* order) noexcept;
    static OtherOrder* installed() noexcept;

    /** For a thread that is about to sleep until another one has done something: true if it has executed something and
        must look again. Real-time safe, and costs nothing, without such an order. */
    static bool executedHere();
    /** How long (monotonic ns) such a thread may sleep: another thread may trigger a component meanwhile. */
    static std::int64_t limit(std::int64_t deadline);
};

}  // namespace internal
}  // namespace RTT

#endif
