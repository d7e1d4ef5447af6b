// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_ENGINE_GATE_HPP
#define ORO_INTERNAL_ENGINE_GATE_HPP

#include <rtt/internal/engine/presence.hpp>
#include <rtt/internal/engine/wait_point.hpp>

#include <boost/smart_ptr/intrusive_ptr.hpp>

#include <atomic>
#include <cstdint>

namespace RTT {
class ExecutionEngine;
namespace base {
class ActivityInterface;
}
namespace internal {

/**
 * The way to an ExecutionEngine that may change its activity, or be destroyed, at any moment. Shared by the engine, the
 * callers of its component's operations and the calls that its component waits for; outlives the engine.
 *
 * A visitor enters the gate and then looks for the engine and the activity. The thread that takes one of them away does
 * that first and then waits for all visitors, see Presence.
 */
class RTT_API EngineGate {
public:
    /** While one exists, the engine and the activity that it gives are not destroyed. Never blocks; real-time safe. */
    class RTT_API Visit {
    public:
        explicit Visit(const EngineGate& gate) noexcept : gate_(gate), place_(Presence::enter(&gate)) {}
        ~Visit() {
            if (Presence::leave(place_)) gate_.deref();  // the engine was destroyed during the visit
        }
        Visit(const Visit&) = delete;
        Visit& operator=(const Visit&) = delete;
        /** Null if it was destroyed, or retired by another thread. */
        ExecutionEngine* engine() const { return gate_.offered(); }
        /** Null if there is none. */
        base::ActivityInterface* activity() const { return gate_.activity_.load(); }

    private:
        const EngineGate& gate_;
        Presence::Place& place_;
    };

    /** A step of the engine in this thread. Steps nest: a sequential activity may execute within another's step. */
    class RTT_API Step {
    public:
        explicit Step(const EngineGate& gate) noexcept;
        ~Step();
        Step(const Step&) = delete;
        Step& operator=(const Step&) = delete;
        /** The engine was destroyed within this step. */
        bool gone() const { return !gate_; }
        /** The engine; null if gone. */
        ExecutionEngine* engine() const { return gate_ ? gate_->engine_.load(std::memory_order_relaxed) : nullptr; }
        const Step* outer() const { return outer_; }
        /** False within another step of the same engine. */
        bool first() const { return place_ != nullptr; }
        /** Puts the component, if there is one that is not gone, into Exception. */
        void fail() const;
        /** Of this thread; null outside a step. */
        static const Step* innermost() noexcept { return innermost_; }

    private:
        friend class EngineGate;
        mutable const EngineGate* gate_;
        const Step* outer_;
        Presence::Place* const place_;  // null if it is not the first
        static thread_local const Step* innermost_ __attribute__((tls_model("initial-exec")));
    };

    /**
     * Exists while this thread touches the component without a message, in a step of the engine or as its activity
     * (base::ActivityInterface::isSelf()). No other thread executes the component meanwhile. Converts to false if this
     * thread must not touch it. Waits for no execution, see ActivityInterface::beginDirect(). Lives on the stack.
     */
    class RTT_API Stand {
    public:
        /** Self: only the component's own thread may. Anybody: any thread may while none executes the component, see
            ActivityInterface::beginInStead(). */
        enum As { Self, Anybody };
        /** A null gate belongs to a component that any thread may touch. */
        explicit Stand(const EngineGate* gate, As as = Self) : granted_(!gate || enter(*gate, as)) {}
        ~Stand() {
            if (entered_) leave();
        }
        Stand(const Stand&) = delete;
        Stand& operator=(const Stand&) = delete;
        explicit operator bool() const { return granted_; }

    private:
        bool enter(const EngineGate& gate, As as);
        void leave();
        base::ActivityInterface* entered_ = nullptr;
        const EngineGate* gate_ = nullptr;                   // if entered
        alignas(Visit) unsigned char visit_[sizeof(Visit)];  // a Visit, if entered
        const bool granted_;
    };

    explicit EngineGate(ExecutionEngine* engine) : engine_(engine), offered_(engine) {}
    EngineGate(const EngineGate&) = delete;
    EngineGate& operator=(const EngineGate&) = delete;

    /** The gate of the engine that this thread is executing; null if there is none. */
    static const EngineGate* ofThisThread() noexcept;
    /** Sleeps while the futex `word` holds `seen`, at most until the monotonic time `deadline` (ns), and executes the
        messages of the components that this thread is executing. May return early. */
    static void sleepOn(const Presence::Word& word, std::uint32_t seen, std::int64_t deadline = INT64_MAX);

    /** The engine was destroyed, or retired by another thread. This and the following functions may be called by any
        thread and are real-time safe, unless they say otherwise. */
    bool closed() const { return offered() == nullptr; }
    /** retire() was called, or the engine was destroyed. */
    bool retired() const { return offered_.load(std::memory_order_acquire) == nullptr; }
    /** For the engine, and for code that knows that it exists. */
    ExecutionEngine* engine() const { return engine_.load(std::memory_order_acquire); }
    base::ActivityInterface* activity() const { return activity_.load(std::memory_order_acquire); }
    /** This thread is within a step of the engine. */
    bool isStepping() const noexcept;
    /** This thread is within a step of the engine, or acts as its activity. */
    bool isSelf() const;

    /** Blocks until no other thread uses the previous one. */
    void setActivity(base::ActivityInterface* activity);
    /** For a thread that is about to destroy the component: refuses all other threads for good, as if the engine were
        destroyed. */
    void retire();
    /** Blocks until no other thread visits the retired engine or is within a step of it, and returns at once from then
        on. False at the monotonic time `deadline` (ns). */
    bool waitUntilLeft(std::int64_t deadline);
    /** Retired by this thread. */
    bool retiredHere() const { return retired() && offeredToRetirer() != nullptr; }
    /** For the destructor of the engine. Blocks until no other thread uses it. */
    void close();
    /** Blocks until the visits of all other threads are over. A component's thread executes its messages meanwhile,
        because the thread that executes a sequential component may be waiting for one of them. */
    void waitForVisitors() const;
    /** Blocks until no thread is within a step; for an engine whose activity is not active. */
    void waitForStep() const;

    mutable WaitPoint waitPoint;

    void ref() const { references_.fetch_add(1, std::memory_order_relaxed); }
    void deref() const;

private:
    /** The address that a thread within a step uses, see Presence. */
    const void* step() const noexcept { return &references_; }
    bool waitFor(const void* use, const char* what, std::int64_t deadline = INT64_MAX) const;
    ExecutionEngine* offered() const {
        ExecutionEngine* const engine = offered_.load();
        return __builtin_expect(engine != nullptr, 1) ? engine : offeredToRetirer();
    }
    ExecutionEngine* offeredToRetirer() const;

    mutable std::atomic<std::uint32_t> references_{0};
    std::atomic<ExecutionEngine*> engine_;
    std::atomic<ExecutionEngine*> offered_;  // null once retired
    std::atomic<int> retirer_{0};            // the thread that last called retire()
    std::atomic<bool> left_{false};          // by all other threads, once retired
    std::atomic<base::ActivityInterface*> activity_{nullptr};
};

inline void intrusive_ptr_add_ref(const EngineGate* gate) { gate->ref(); }
inline void intrusive_ptr_release(const EngineGate* gate) { gate->deref(); }

}  // namespace internal
}  // namespace RTT

#endif
