// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_MACHINE_STATUS_HPP
#define ORO_SCRIPTING_DETAIL_MACHINE_STATUS_HPP

#include <rtt/scripting/StateMachine.hpp>
#include <rtt/scripting/detail/machine/machine_model.hpp>

#include <diag/diagnostic.hpp>

#include <atomic>
#include <string>

namespace RTT::scripting::detail {

/** Observes a machine. Called in the thread that executes it. */
class MachineObserver {
public:
    virtual ~MachineObserver();
    /** `what` and the name of a state. Only called while traced. */
    virtual void did(const char* what, const std::string& state) = 0;
    virtual void failed(const oroforge::diag::Location& where, const std::string& why) = 0;
};

/** What every thread may see of a machine, and request from it. */
class MachineStatus {
public:
    typedef StateMachine::Status Status;
    typedef StateMachine::StateMachineStatus Value;
    /** Requests that have not taken effect. kStop is the first: stop() cancels earlier requests, and a later pause
        waits for it. */
    enum Request : unsigned { kPause = 1, kStep = 2, kStop = 4 };

    explicit MachineStatus(MachineObserver& observer) : observer_(observer) {}

    // -- Any thread -----------------------------------------------------------------------------------------
    /** The status; stopping from the request on. */
    Value value() const;
    MachineState* state() const { return current_.load(std::memory_order_acquire); }
    bool inTransition() const { return in_transition_.load(std::memory_order_acquire); }
    unsigned line() const { return line_.load(std::memory_order_relaxed); }
    void setTraced(bool on) { traced_.store(on, std::memory_order_relaxed); }
    bool pause();
    bool step();
    bool stop();

    // -- The thread that has the machine --------------------------------------------------------------------
    Value now() const { return status_.load(std::memory_order_relaxed); }
    bool failed() const { return now() == Status::error; }
    void set(Value status) { status_.store(status, std::memory_order_release); }
    MachineState& present() const { return *current_.load(std::memory_order_relaxed); }
    void setState(MachineState* state) { current_.store(state, std::memory_order_release); }
    void setInTransition(bool on) { in_transition_.store(on, std::memory_order_release); }
    void setLine(unsigned line) { line_.store(line, std::memory_order_relaxed); }
    bool hasRequests() const { return requests_.load(std::memory_order_relaxed) != 0; }
    /** The requests that take effect now. */
    unsigned takeRequests();
    void cancelRequests() { requests_ = 0; }
    /** An earlier pause or step must not hide the error. */
    void fail(const oroforge::diag::Location& where, const std::string& why);
    void tell(const char* what) { tell(what, present()); }
    void tell(const char* what, const MachineState& state) {
        if (traced_.load(std::memory_order_relaxed)) observer_.did(what, state.name);
    }

private:
    MachineObserver& observer_;
    std::atomic<Value> status_{Status::inactive};
    std::atomic<MachineState*> current_{nullptr};
    std::atomic<unsigned> requests_{0};
    std::atomic<unsigned> line_{0};
    std::atomic<bool> in_transition_{false};
    std::atomic<bool> traced_{false};
};

}  // namespace RTT::scripting::detail

#endif
