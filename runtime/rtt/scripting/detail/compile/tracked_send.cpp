// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/tracked_send.hpp>

#include <rtt/internal/engine/engine_gate.hpp>
#include <rtt/internal/calls/failure_report.hpp>
#include <rtt/internal/calls/sent_call.hpp>

#include <algorithm>
#include <utility>

namespace RTT::scripting::detail {

using internal::FailureReport;
using internal::SentCall;
using oroforge::diag::Severity;

namespace {

// How long the end of a script waits for calls that it sent.
constexpr std::chrono::seconds kPatience(1);

/** Takes the place of the call in the queue of an engine. */
class ToldMessage final : public base::DisposableInterface {
public:
    ToldMessage(SentCall& call, std::shared_ptr<SentOutcome> outcome)
        : call_(&call, false), held_(&call), outcome_(std::move(outcome)) {}

    void executeAndDispose() override {
        const std::unique_ptr<ToldMessage> self(this);
        FailureReport report;
        {
            const FailureReport::OfSent given(report);
            call_.detach()->executeAndDispose();
        }
        const bool done = held_->state() == SentCall::Done;
        outcome_->end(report.reasons(), done && !*static_cast<const bool*>(held_->resultAddress()));
    }
    void dispose() override {
        const std::unique_ptr<ToldMessage> self(this);
        call_.detach()->dispose();
        outcome_->end({}, false);
    }
    bool isError() const override { return held_->isError(); }

private:
    SentCall::shared_ptr call_;  // the reference that the queue owned
    const SentCall::shared_ptr held_;
    const std::shared_ptr<SentOutcome> outcome_;
};

}  // namespace

SentOutcome::~SentOutcome() {
    if (!kept_.empty()) logFailure(Severity::Error, place, kept_);
}

void SentOutcome::end(const std::string& reasons, bool failed) {
    const bool strict = failed && FailureReport::isStrict();
    if (!reasons.empty() && !(strict && keeps_))
        logFailure(strict ? Severity::Error : Severity::Warning, place, reasons);
    const std::lock_guard<std::mutex> lock(mutex_);
    over_ = true;
    if (strict) failure_ = reasons;
    if (strict && keeps_) kept_ = reasons;
    ended_.notify_all();
}

std::string SentOutcome::ask() {
    std::unique_lock<std::mutex> lock(mutex_);
    ended_.wait(lock, [this] { return over_; });
    return taken();
}

std::string SentOutcome::taken() {
    kept_.clear();
    return std::exchange(failure_, {});
}

bool SentOutcome::settle(std::chrono::steady_clock::time_point end) {
    std::unique_lock<std::mutex> lock(mutex_);
    ended_.wait_until(lock, end, [this] { return over_; });
    if (!kept_.empty()) logFailure(Severity::Error, place, kept_);
    return taken().empty();
}

bool SentOutcome::isGood() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return over_ && failure_.empty();
}

std::shared_ptr<SentOutcome> LastSent::get() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return outcome_;
}

void LastSent::set(std::shared_ptr<SentOutcome> outcome) {
    const std::lock_guard<std::mutex> lock(mutex_);
    outcome_.swap(outcome);
}

void SentCalls::add(std::shared_ptr<SentOutcome> outcome) {
    const auto isGood = [](const std::shared_ptr<SentOutcome>& each) { return each->isGood(); };
    if (all_.size() == all_.capacity()) all_.erase(std::remove_if(all_.begin(), all_.end(), isGood), all_.end());
    all_.push_back(std::move(outcome));
}

bool SentCalls::settle() {
    // A component must not wait just to log a failure, because it may have to execute the call itself.
    const bool waits = FailureReport::isStrict() || !internal::EngineGate::ofThisThread();
    const auto end = std::chrono::steady_clock::now() + (waits ? kPatience : std::chrono::seconds(0));
    bool good = true;
    for (const auto& each : all_) good = each->settle(end) && good;
    all_.clear();
    return good;
}

TrackedSend::TrackedSend(const internal::CalleeBase* callee, CallPlace place, std::shared_ptr<LastSent> last,
                         std::shared_ptr<SentCalls> calls, bool forgotten)
    : callee_(callee),
      place_(std::move(place)),
      last_(std::move(last)),
      calls_(std::move(calls)),
      forgotten_(forgotten) {}

base::DisposableInterface* TrackedSend::queued(SentCall& call) {
    const auto outcome = std::make_shared<SentOutcome>(place_, !forgotten_);
    if (calls_) calls_->add(outcome);
    if (last_) last_->set(outcome);
    return new ToldMessage(call, outcome);
}

TrackedCollect::TrackedCollect(internal::DataSource<SendStatus>* collect, std::shared_ptr<LastSent> last, bool ignored,
                               bool elsewhere)
    : collect_(collect), last_(std::move(last)), ignored_(ignored), elsewhere_(elsewhere) {}

bool TrackedCollect::evaluate() const {
    if (!collect_->evaluate()) return false;
    check();
    return true;
}

SendStatus TrackedCollect::get() const {
    const SendStatus status = collect_->get();
    check();
    return status;
}

void TrackedCollect::check() const {
    if (collect_->value() != SendSuccess) return;
    const std::shared_ptr<SentOutcome> outcome = last_->get();
    const std::string failure = outcome ? outcome->ask() : std::string();
    if (failure.empty()) return;
    if (!ignored_) return logFailure(Severity::Warning, outcome->place, failure);
    FailedCall failed(outcome->place, failure);
    if (elsewhere_) failed.leaves("it is collected here");
    throw failed;
}

TrackedCollect* TrackedCollect::clone() const {
    return new TrackedCollect(collect_->clone(), last_, ignored_, elsewhere_);
}

TrackedCollect* TrackedCollect::copy(
    std::map<const base::DataSourceBase*, base::DataSourceBase*>& alreadyCloned) const {
    base::DataSourceBase*& made = alreadyCloned[this];
    if (!made) made = new TrackedCollect(collect_->copy(alreadyCloned), last_, ignored_, elsewhere_);
    return static_cast<TrackedCollect*>(made);
}

}  // namespace RTT::scripting::detail
