// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Calls that a script sends, of operations that give reasons if they return false: told with the place where they were sent.
#ifndef ORO_SCRIPTING_DETAIL_TOLD_SEND_HPP
#define ORO_SCRIPTING_DETAIL_TOLD_SEND_HPP

#include <rtt/SendStatus.hpp>
#include <rtt/internal/DataSource.hpp>
#include <rtt/internal/Sending.hpp>
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

/** How a call ends that was sent. The script that sent it may be told of a failure, if that is strict; else, and if it does not
    ask, the log is. Any thread. */
class SentOutcome {
public:
    /** `keeps`: a failure waits for somebody who asks. */
    SentOutcome(CallPlace place, bool keeps) : place(std::move(place)), keeps_(keeps) {}
    ~SentOutcome();
    SentOutcome(const SentOutcome&) = delete;
    SentOutcome& operator=(const SentOutcome&) = delete;

    /** The call is over. */
    void end(const std::string& reasons, bool failed);
    /** Waits for the end. Why it failed, for the first one who asks; empty: it did not. */
    std::string ask();
    /** At the end of the script, which waits until `end`: false, and told, if it failed and nobody has asked. */
    bool settle(std::chrono::steady_clock::time_point end);
    /** True if there is nothing to be told. */
    bool isGood();

    const CallPlace place;

private:
    std::string taken();

    const bool keeps_;
    std::mutex mutex_;
    std::condition_variable ended_;
    bool over_ = false;
    std::string failure_;  // that nobody has asked for yet
    std::string kept_;     // that is not in the log yet
};

/** The call that was sent last at some place, or by some handle. Any thread. */
class LastSent {
public:
    std::shared_ptr<SentOutcome> get() const;
    void set(std::shared_ptr<SentOutcome> outcome);
    /** Where one may be told: from then on. */
    void use() { used_ = true; }
    bool isUsed() const { return used_; }

private:
    mutable std::mutex mutex_;
    std::atomic<bool> used_{false};
    std::shared_ptr<SentOutcome> outcome_;
};

/** What the statements of a script sent. One thread. */
class SentCalls {
public:
    void add(std::shared_ptr<SentOutcome> outcome);
    /** Waits a little for those under way: their component may be gone after the script. False, and told, if one failed, that is
        strict, and the script does not know of it. */
    bool settle();

private:
    std::vector<std::shared_ptr<SentOutcome>> all_;
};

/** Sees to it that calls which are sent at one place are told, in the thread that executes them. */
class ToldSend final : public internal::Sending::Watcher {
public:
    /** `calls` may be null. Nobody collects what is `forgotten`. */
    ToldSend(const internal::CalleeBase* callee, CallPlace place, std::shared_ptr<LastSent> last,
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

/** Collects. Where failures are strict, one of a call whose result is ignored fails the statement. */
class ToldCollect final : public internal::DataSource<SendStatus> {
public:
    /** `elsewhere`: where it collects is another place than where it was sent. */
    ToldCollect(internal::DataSource<SendStatus>* collect, std::shared_ptr<LastSent> last, bool ignored,
                bool elsewhere);

    bool evaluate() const override;
    SendStatus get() const override;
    SendStatus value() const override { return collect_->value(); }
    const SendStatus& rvalue() const override { return collect_->rvalue(); }
    ToldCollect* clone() const override;
    ToldCollect* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& alreadyCloned) const override;

private:
    void check() const;

    const internal::DataSource<SendStatus>::shared_ptr collect_;
    const std::shared_ptr<LastSent> last_;
    const bool ignored_;
    const bool elsewhere_;
};

}  // namespace RTT::scripting::detail

#endif
