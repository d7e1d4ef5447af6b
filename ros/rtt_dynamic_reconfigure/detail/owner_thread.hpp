// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_DYNAMIC_RECONFIGURE_DETAIL_OWNER_THREAD_HPP
#define RTT_DYNAMIC_RECONFIGURE_DETAIL_OWNER_THREAD_HPP

#include <boost/intrusive_ptr.hpp>

#include <atomic>
#include <functional>
#include <mutex>
#include <string>

namespace RTT {
class TaskContext;
namespace internal {
class EngineGate;
}
}  // namespace RTT

namespace rtt_dynamic_reconfigure::detail {

/** Executes functions while nobody else executes the component. Outlives the component. */
class OwnerThread {
public:
    typedef std::function<void(RTT::TaskContext& owner)> Work;

    /** Null for a service without a component. */
    explicit OwnerThread(RTT::TaskContext* owner);
    ~OwnerThread();

    /** In the component's thread or, if nobody executes the component, in this one. Waits for that, and serves the
        components of this thread meanwhile; false, with the reason, if it was not executed within 5 s, or if `isClosed`
        became true first. Any thread. `work` must not throw. */
    bool execute(const Work& work, const std::atomic<bool>& isClosed, std::string& why);
    /** Of the component. */
    const std::string& name() const { return name_; }

private:
    bool executeHere(const Work& work);

    RTT::TaskContext* const owner_;  // exists if the gate says so
    const boost::intrusive_ptr<const RTT::internal::EngineGate> gate_;
    const std::string name_;
    std::recursive_mutex direct_;  // for threads that execute it themselves
};

}  // namespace rtt_dynamic_reconfigure::detail

#endif
