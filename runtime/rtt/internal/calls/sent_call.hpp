// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_SENT_CALL_HPP
#define ORO_INTERNAL_SENT_CALL_HPP

#include <rtt/SendStatus.hpp>
#include <rtt/base/DisposableInterface.hpp>
#include <rtt/internal/calls/call_pool.hpp>
#include <rtt/internal/calls/callee.hpp>

#include <boost/smart_ptr/intrusive_ptr.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <string>

namespace RTT {
class ExecutionEngine;
namespace internal {

class EngineGate;

/** Collects a call that was queued elsewhere. */
class RTT_API RemoteCollect {
public:
    virtual ~RemoteCollect();
    /** Fills in the result and the arguments when the operation is done. Throws what the operation throws. */
    virtual SendStatus collect(bool wait) = 0;
};

/** A call on its way through the queue of an engine, and its result afterwards. The queue and the caller's handles
    refer to it. Memory comes from CallPool. */
class RTT_API SentCall : public base::DisposableInterface {
public:
    typedef boost::intrusive_ptr<SentCall> shared_ptr;

    enum State { Waiting, Done, Threw, Disposed };

    explicit SentCall(CalleeBase* callee);
    ~SentCall() override;
    SentCall(const SentCall&) = delete;
    SentCall& operator=(const SentCall&) = delete;

    void executeAndDispose() final;
    void dispose() final;
    bool isError() const final { return state() == Threw; }
    CalleeBase* callee() const { return callee_.get(); }
    State state() const { return static_cast<State>(state_.load(std::memory_order_acquire) & ~kParked); }

    /** Prepares a finished call for reuse. False if another reference to it exists. */
    bool beginAgain();
    /** The engine of the component that collects, null if there is none, and the engine that executes. */
    void setEngines(ExecutionEngine* caller, ExecutionEngine* executor);

    /** The component of the function, if another engine executes it. It is not destroyed while the call is executed;
        after its destruction the call is disposed. `blamed`: it enters Exception if the call throws. */
    void setProvider(const boost::intrusive_ptr<const EngineGate>& provider, bool blamed);

    /** For a call that is executed elsewhere. */
    void collectFrom(std::unique_ptr<RemoteCollect> remote);

    SendStatus status() const;
    /** Waits for the end, in the thread of the caller. Throws as checkError() does. */
    SendStatus collect();
    /** The same without waiting. */
    SendStatus collectIfDone();
    /** For a thread that did not send it: waits for the end, at most until the monotonic time `deadline` (ns), and
        executes the messages of the components that it is executing. False if the end has not come. */
    bool endsBefore(std::int64_t deadline);
    /** If the operation threw: throws std::runtime_error with the text of that exception. */
    void checkError() const;

    /** The address of the result; null if there is none. */
    virtual const void* resultAddress() const = 0;
    /** The address of the copy of an argument, counted from 0. */
    virtual void* argumentAddress(unsigned index) = 0;

    // The destructor is virtual, so the size is that of the subclass.
    static void* operator new(std::size_t size) { return CallPool::take(size); }
    static void operator delete(void* block) { CallPool::give(block); }
    // Arguments of larger alignment (Eigen with AVX) do not fit into the pool's blocks.
    static void* operator new(std::size_t size, std::align_val_t alignment) { return ::operator new(size, alignment); }
    static void operator delete(void* block, std::align_val_t alignment) { ::operator delete(block, alignment); }

    void ref() { references_.fetch_add(1, std::memory_order_relaxed); }
    void deref();

protected:
    /** Runs the function and keeps its result. */
    virtual void run();
    ExecutionEngine* executor() const { return executor_; }

private:
    static constexpr std::uint32_t kParked = 0x80000000u;  // in state_: a thread sleeps on it
    void finish(State state);
    void threw(const char* what);
    void park();

    std::atomic<int> references_{0};
    std::atomic<std::uint32_t> state_{Waiting};
    const boost::intrusive_ptr<CalleeBase> callee_;
    ExecutionEngine* executor_ = nullptr;
    std::unique_ptr<std::string> error_;  // set before the state becomes Threw
    std::unique_ptr<RemoteCollect> remote_;
    boost::intrusive_ptr<const EngineGate> waiting_;  // of the engine whose thread waits; null if sent without a caller
    boost::intrusive_ptr<const EngineGate> provider_;
    bool blamed_ = false;
};

/**
 * For an operation of a component that threw outside the component's thread: logs it and puts the component into
 * Exception, unless it is in that state already. The component's thread executes the hooks, as if the operation ran
 * there; this waits for that, up to 100 ms if the component is busy. Without an active thread, this one executes them.
 */
RTT_API void blame(const EngineGate& owner, CalleeBase* callee, const char* what);

inline void intrusive_ptr_add_ref(SentCall* call) { call->ref(); }
inline void intrusive_ptr_release(SentCall* call) { call->deref(); }

}  // namespace internal
}  // namespace RTT

#endif
