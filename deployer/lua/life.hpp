// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_LIFE_HPP
#define OCL_LUA_LIFE_HPP

#include <rtt/internal/engine/engine_gate.hpp>

#include <boost/smart_ptr/intrusive_ptr.hpp>

#include <optional>

namespace RTT {
class Service;
class TaskContext;
}  // namespace RTT

namespace OCL::lua {

/** Whether the component to which something belongs still exists. */
class Life {
public:
    /** Of something that belongs to no component. */
    Life() = default;
    explicit Life(RTT::TaskContext& component);
    /** Of the component of this service, if it has one. */
    explicit Life(const RTT::Service& service);

    /** While one exists, no other thread destroys the component; a thread that wants to, waits. Throws Failure if it is
        over. Lives on the stack. */
    class Use {
    public:
        Use(const Life& life, const char* what) : gate_(life.gate_) {
            if (!gate_) return;
            visit_.emplace(*gate_);
            if (!visit_->engine()) fail(what);
        }

    private:
        const boost::intrusive_ptr<const RTT::internal::EngineGate> gate_;
        std::optional<RTT::internal::EngineGate::Visit> visit_;
    };

    bool isOver() const { return gate_ && gate_->retired(); }
    /** Throws Failure if it is over. */
    void check(const char* what) const {
        if (isOver()) fail(what);
    }

private:
    [[noreturn]] static void fail(const char* what);
    boost::intrusive_ptr<const RTT::internal::EngineGate> gate_;
};

}  // namespace OCL::lua

#endif
