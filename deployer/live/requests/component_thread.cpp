// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "component_thread.hpp"

#include "failure.hpp"
#include "ticket.hpp"

#include <rtt/ExecutionEngine.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/base/DisposableInterface.hpp>
#include <rtt/os/fosi.h>
#include <rtt/os/futex.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <sstream>
#include <utility>
#include <vector>

namespace OCL::live {
namespace {

using RTT::internal::EngineGate;

/** So often a thread that waits looks whether somebody still wants the answer, in ns. */
constexpr std::int64_t kLook = 100000000;

/** The message and its end. The queue and the thread that waits refer to it. */
class Message final : public RTT::base::DisposableInterface {
public:
    enum State : std::uint32_t { Waiting, Begun, Done, Disposed, Abandoned };

    explicit Message(std::function<void()> work) : work_(std::move(work)) {}

    void executeAndDispose() override {
        std::uint32_t expected = Waiting;
        if (state_.compare_exchange_strong(expected, Begun)) {
            try {
                work_();
            } catch (...) {
                thrown_ = std::current_exception();
            }
            finish(Done);
        }
        deref();
    }
    void dispose() override {
        std::uint32_t expected = Waiting;
        if (state_.compare_exchange_strong(expected, Disposed)) wake();
        deref();
    }

    /** Done, or what else has become of it at the deadline. */
    State wait(std::int64_t deadline) {
        for (;;) {
            std::uint32_t seen = state_;
            if (seen == Done || seen == Disposed) return static_cast<State>(seen);
            if (rtos_get_time_ns() >= deadline) {
                if (seen == Begun || state_.compare_exchange_strong(seen, Abandoned)) return static_cast<State>(seen);
                continue;
            }
            if (seen == Waiting && WorkFor::isOver()) deadline = 0;
            RTT::os::detail::futexWait(state_, seen, std::min<std::int64_t>(deadline, rtos_get_time_ns() + kLook));
        }
    }
    void rethrow() const {
        if (thrown_) std::rethrow_exception(thrown_);
    }

    bool isOnlyKept() const { return references_.load(std::memory_order_acquire) == 1; }
    void ref() { references_.fetch_add(1, std::memory_order_relaxed); }
    void deref() {
        if (references_.fetch_sub(1, std::memory_order_acq_rel) == 1) delete this;
    }
    friend void intrusive_ptr_add_ref(Message* message) { message->ref(); }
    friend void intrusive_ptr_release(Message* message) { message->deref(); }

private:
    void finish(State state) {
        state_ = state;
        wake();
    }
    void wake() { RTT::os::detail::futexWakeAll(state_); }

    const std::function<void()> work_;
    std::exception_ptr thrown_;
    std::atomic<std::uint32_t> state_{Waiting};
    std::atomic<int> references_{0};
};

typedef boost::intrusive_ptr<Message> MessagePtr;

/** Keeps messages until no component holds them, so that none frees memory in the thread of a component. */
class Keeper {
public:
    explicit Keeper(MessagePtr message) { exchange(std::move(message)); }
    ~Keeper() { exchange(nullptr); }
    Keeper(const Keeper&) = delete;
    Keeper& operator=(const Keeper&) = delete;

private:
    static void exchange(MessagePtr added) {
        static std::mutex mutex;
        static auto* const kept = new std::vector<MessagePtr>();  // never destroyed: threads may outlive statics
        std::vector<MessagePtr> done;
        const std::lock_guard<std::mutex> lock(mutex);
        const auto isHeld = [](const MessagePtr& each) { return !each->isOnlyKept(); };
        const auto first = std::stable_partition(kept->begin(), kept->end(), isHeld);
        done.assign(std::make_move_iterator(first), std::make_move_iterator(kept->end()));
        kept->erase(first, kept->end());
        if (added) kept->push_back(std::move(added));
    }
};

/** True if this thread has executed it. */
bool executedHere(const EngineGate& gate, const std::string& name, const std::function<void()>& work) {
    const EngineGate::Visit visit(gate);
    if (!visit.engine()) throw Failure(kGone, "component '" + name + "' was destroyed");
    const EngineGate::Stand here(&gate, EngineGate::Stand::Anybody);
    if (!here && visit.activity() && visit.activity()->isActive()) return false;
    work();
    return true;
}

}  // namespace

void inThreadOf(const Gate& gate, const std::string& name, const Limit& limit, std::function<void()> work) {
    if (executedHere(*gate, name, work)) return;
    MessagePtr message(new Message(std::move(work)));
    const Keeper keeper(message);
    // Before the keeper looks for what nobody holds.
    const std::unique_ptr<MessagePtr, void (*)(MessagePtr*)> released(&message,
                                                                      [](MessagePtr* held) { held->reset(); });
    message->ref();  // for the queue
    if (!RTT::ExecutionEngine::process(*gate, message.get())) {
        message->deref();
        throw Failure(kGone, gate->closed() ? "component '" + name + "' was destroyed"
                                            : "component '" + name +
                                                  "' takes no messages: its queue is full, or it is "
                                                  "in FatalError");
    }
    switch (message->wait(limit.deadline)) {
        case Message::Done: return message->rethrow();
        case Message::Disposed: throw Failure(kGone, "component '" + name + "' was destroyed");
        case Message::Begun:
            throw Failure(kNoAnswer, "component '" + name + "' did not end this within " + secondsText(limit.seconds) +
                                         "; it is still executing it");
        default:
            throw Failure(kNoAnswer, "component '" + name + "' did not answer within " + secondsText(limit.seconds) +
                                         "; this will not be done");
    }
}

std::int64_t deadlineIn(double seconds) { return rtos_get_time_ns() + static_cast<std::int64_t>(seconds * 1e9); }

std::string secondsText(double seconds) {
    std::ostringstream text;
    text << (seconds < 10 ? std::round(seconds * 100) / 100 : std::round(seconds)) << " s";
    return text.str();
}

}  // namespace OCL::live
