// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DYNAMIC_RECONFIGURE_DETAIL_OWNER_THREAD_HPP
#define RTT_DYNAMIC_RECONFIGURE_DETAIL_OWNER_THREAD_HPP

#include <atomic>
#include <functional>
#include <mutex>
#include <string>

namespace RTT {
class TaskContext;
}

namespace rtt_dynamic_reconfigure::detail {

/** Executes functions while nobody else executes the component. */
class OwnerThread {
public:
    /** In the component's thread or, if nobody executes the component, in this one. Waits for that, and serves the
        components of this thread meanwhile; false, with the reason, if it was not executed within 5 s, or if `isClosed`
        became true first. Any thread. `work` must not throw. */
    bool execute(RTT::TaskContext& owner, const std::function<void()>& work, const std::atomic<bool>& isClosed,
                 std::string& why);

private:
    std::recursive_mutex direct_;  // for threads that execute it themselves
};

}  // namespace rtt_dynamic_reconfigure::detail

#endif
