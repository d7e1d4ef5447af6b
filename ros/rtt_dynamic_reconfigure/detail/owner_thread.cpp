// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_dynamic_reconfigure/detail/owner_thread.hpp>

#include <rtt/ExecutionEngine.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/os/fosi.h>
#include <rtt/os/futex.hpp>

#include <memory>
#include <utility>

namespace rtt_dynamic_reconfigure::detail {

using RTT::internal::EngineGate;

namespace {

constexpr std::int64_t kPatience = 5000000000;  // ns
constexpr std::int64_t kGlance = 20000000;      // how often `isClosed` is looked at

/** A message for the engine. Its sender waits for it, so it may refer to the sender's variables while it runs. */
class Job final : public RTT::base::DisposableInterface {
public:
    enum State : std::uint32_t { Waiting, Running, Done, Dropped };

    explicit Job(const std::function<void()>& work) : work_(work) {}

    static bool send(const std::shared_ptr<Job>& job, const EngineGate& gate) {
        job->self_ = job;
        if (RTT::ExecutionEngine::process(gate, job.get())) return true;
        job->self_.reset();
        return false;
    }
    void executeAndDispose() override {
        const std::shared_ptr<Job> self = std::move(self_);
        if (!change(Waiting, Running)) return;
        work_();
        (void)change(Running, Done);
    }
    void dispose() override {
        const std::shared_ptr<Job> self = std::move(self_);
        (void)change(Waiting, Dropped);
    }
    bool withdraw() { return change(Waiting, Dropped); }
    State state() const { return State(state_.load(std::memory_order_acquire)); }
    void sleepWhile(State seen) const { EngineGate::sleepOn(state_, seen, rtos_get_time_ns() + kGlance); }

private:
    bool change(std::uint32_t from, State to) {
        if (!state_.compare_exchange_strong(from, to)) return false;
        RTT::os::detail::futexWakeAll(state_);
        return true;
    }
    const std::function<void()>& work_;
    std::atomic<std::uint32_t> state_{Waiting};
    std::shared_ptr<Job> self_;  // while it is queued
};

}  // namespace

OwnerThread::OwnerThread(RTT::TaskContext* owner)
    : owner_(owner),
      gate_(owner ? owner->engine()->gate() : nullptr),
      name_(owner ? owner->getName() : std::string()) {}

OwnerThread::~OwnerThread() = default;

bool OwnerThread::executeHere(const Work& work) {
    // During the visit the component is not destroyed.
    const EngineGate::Visit visit(*gate_);
    if (!visit.engine()) return false;
    for (const EngineGate::Stand::As as : {EngineGate::Stand::Self, EngineGate::Stand::Anybody}) {
        const EngineGate::Stand stand(gate_.get(), as);
        if (!stand) continue;
        const std::lock_guard<std::recursive_mutex> lock(direct_);
        work(*owner_);
        return true;
    }
    if (visit.activity() && visit.activity()->isActive()) return false;
    const std::lock_guard<std::recursive_mutex> lock(direct_);
    work(*owner_);
    return true;
}

bool OwnerThread::execute(const Work& work, const std::atomic<bool>& isClosed, std::string& why) {
    if (!gate_) {
        why = "the service belongs to no component";
        return false;
    }
    if (executeHere(work)) return true;
    const std::function<void()> bound = [&] { work(*owner_); };
    const auto job = std::make_shared<Job>(bound);
    if (!Job::send(job, *gate_)) {
        why = "component '" + name_ + "' takes no messages";
        return false;
    }
    const std::int64_t deadline = rtos_get_time_ns() + kPatience;
    for (;;) {
        const Job::State state = job->state();
        if (state == Job::Done) return true;
        if (state == Job::Dropped) {
            why = "component '" + name_ + "' was busy for 5 s, or it goes away";
            return false;
        }
        if (state == Job::Waiting && (isClosed || rtos_get_time_ns() > deadline))
            (void)job->withdraw();
        else
            job->sleepWhile(state);
    }
}

}  // namespace rtt_dynamic_reconfigure::detail
