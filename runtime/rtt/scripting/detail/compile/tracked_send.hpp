// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Reports failures of calls that a script sends, with the place where they were sent.
#ifndef ORO_SCRIPTING_DETAIL_TRACKED_SEND_HPP
#define ORO_SCRIPTING_DETAIL_TRACKED_SEND_HPP

#include <rtt/SendStatus.hpp>
#include <rtt/internal/DataSource.hpp>
#include <rtt/internal/calls/sending.hpp>
#include <rtt/scripting/detail/execute/failed_call.hpp>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace RTT::scripting::detail {

/** The outcome of a sent call. If failures are strict, the script that sent it may ask for its failure; otherwise, or
    if it does not ask, the failure is logged. Any thread. */
class SentOutcome {
public:
    /** `keeps`: a failure is kept for ask(). */
    SentOutcome(CallPlace place, bool keeps) : place(std::move(place)), keeps_(keeps) {}
    ~SentOutcome();
    SentOutcome(const SentOutcome&) = delete;
    SentOutcome& operator=(const SentOutcome&) = delete;

    /** Notes that the call has ended. */
    void end(const std::string& reasons, bool failed);
    /** Waits for the end. Returns why the call failed, to the first caller only; empty if it did not fail. */
    std::string ask();
    /** Waits, at the end of the script, until `end`. If the call failed and nobody has asked, reports it and returns
        false. */
    bool settle(std::chrono::steady_clock::time_point end);
    /** True if there is nothing to report. */
    bool isGood();

    const CallPlace place;

private:
    std::string taken();

    const bool keeps_;
    std::mutex mutex_;
    std::condition_variable ended_;
    bool over_ = false;
    std::string failure_;  // not asked for yet
    std::string kept_;     // not logged yet
};

/** The last call that was sent at a place or with a handle. Any thread. */
class LastSent {
public:
    std::shared_ptr<SentOutcome> get() const;
    void set(std::shared_ptr<SentOutcome> outcome);
    /** Notes that the script may ask, from now on. */
    void use() { used_ = true; }
    bool isUsed() const { return used_; }

private:
    mutable std::mutex mutex_;
    std::atomic<bool> used_{false};
    std::shared_ptr<SentOutcome> outcome_;
};

/** The calls that the statements of a script sent. For one thread. */
class SentCalls {
public:
    void add(std::shared_ptr<SentOutcome> outcome);
    /** Waits a little for calls that have not ended, because their component may be destroyed after the script. If
        failures are strict and one failed without the script asking, reports it and returns false. */
    bool settle();

private:
    std::vector<std::shared_ptr<SentOutcome>> all_;
};

/** Reports failures of calls that are sent at one place, in the thread that executes them. */
class TrackedSend final : public internal::Sending::Watcher {
public:
    /** `calls` may be null. `forgotten`: the call is never collected. */
    TrackedSend(const internal::CalleeBase* callee, CallPlace place, std::shared_ptr<LastSent> last,
                std::shared_ptr<SentCalls> calls, bool forgotten);

    internal::Sending announcement() { return {callee_, this}; }
    base::DisposableInterface* queued(internal::SentCall& call) override;

private:
    const internal::CalleeBase* const callee_;
    const CallPlace place_;
    const std::shared_ptr<LastSent> last_;
    const std::shared_ptr<SentCalls> calls_;
    const bool forgotten_;
};

/** Collects a call. If failures are strict and the result is ignored, a failure of the call fails the statement. */
class TrackedCollect final : public internal::DataSource<SendStatus> {
public:
    /** `elsewhere`: it is collected at another place than where it was sent. */
    TrackedCollect(internal::DataSource<SendStatus>* collect, std::shared_ptr<LastSent> last, bool ignored,
                   bool elsewhere);

    bool evaluate() const override;
    SendStatus get() const override;
    SendStatus value() const override { return collect_->value(); }
    const SendStatus& rvalue() const override { return collect_->rvalue(); }
    TrackedCollect* clone() const override;
    TrackedCollect* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& alreadyCloned) const override;

private:
    void check() const;

    const internal::DataSource<SendStatus>::shared_ptr collect_;
    const std::shared_ptr<LastSent> last_;
    const bool ignored_;
    const bool elsewhere_;
};

}  // namespace RTT::scripting::detail

#endif
