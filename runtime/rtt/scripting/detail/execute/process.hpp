// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Executes a Code, and can stop between statements and continue there.
#ifndef ORO_SCRIPTING_DETAIL_PROCESS_HPP
#define ORO_SCRIPTING_DETAIL_PROCESS_HPP

#include <rtt/scripting/detail/execute/code.hpp>
#include <rtt/scripting/detail/execute/failed_call.hpp>
#include <rtt/scripting/detail/execute/peers.hpp>

#include <diag/diagnostic.hpp>

#include <atomic>
#include <memory>
#include <string>
#include <utility>

namespace RTT::scripting::detail {

struct Activation;

/** Belongs to one thread at a time, except where stated. Functions neither allocate nor lock nor look up names, except
    in called operations and for the message of a failure. */
class Process {
public:
    enum class Outcome {
        Finished,  ///< the end was reached, or a `return`
        Yielded,   ///< continues in the next step
        Paused,    ///< pause() was called; run() continues
        Failed     ///< see message(); stays at the statement that failed
    };

    /** Starts at the beginning of `code`, which must outlive this. */
    explicit Process(const Code& code);
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /** Executes statements until one of the outcomes above. */
    Outcome run();
    /** As run(), for results that are needed at once: continues after yields, and fails if there are too many. */
    Outcome runToEnd();
    /** After Yielded: true at a `nothing` or a command, with which scripts wait without limit. */
    bool idles() const { return idles_; }
    /** Executes one statement. Yielded if there are more. */
    Outcome runStatement();
    /** Goes back to the beginning and clears a failure. Variables keep their values. */
    void restart();
    /** After Failed: makes run() execute the failed statement again, within its function. */
    void retry();
    /** True from the first run() until Finished or restart(). */
    bool started() const { return started_; }
    /** Makes run() return Paused after the current statement; any thread. */
    void pause() { pause_.store(true, std::memory_order_relaxed); }
    /** The statement that is next, or that failed; {0, 0} if there is none. Any thread; gives the state of the last
        stop. */
    ast::Place place() const;
    unsigned line() const { return place().line; }
    /** Why it failed, without a place. */
    const std::string& message() const { return message_; }
    bool failed() const { return failed_; }
    /** The call that made it fail; null for other reasons. */
    const FailedCall* failedCall() const { return failed_call_.get(); }
    /** After Failed: reports why and where, with the functions that were called. `whole` is "program 'p'", or empty for
        a statement of that file. */
    void report(oroforge::diag::Sink& sink, const oroforge::diag::FileName& file, const std::string& whole) const;
    /** True if it failed because the thread was interrupted, see internal::Interruption. */
    bool interrupted() const { return interrupted_; }

    /** Makes it fail, without a chance to catch it, after one of these components was destroyed. Checked at the
        beginning and after calls. */
    void watch(std::shared_ptr<const Peers> peers) { peers_ = std::move(peers); }

    /** Limits the rounds of loops within one run(), beyond which it fails; 0 for no limit. */
    void setRoundLimit(unsigned limit) { round_limit_ = limit; }

    // -- For instructions -----------------------------------------------------------------------------------
    /** Yields, to continue with `next` in the next step. */
    const Instruction* yieldTo(const Instruction* next) {
        idles_ = false;
        return stop(Outcome::Yielded, next);
    }
    /** The same for a script that waits. */
    const Instruction* idleTo(const Instruction* next) {
        idles_ = true;
        return stop(Outcome::Yielded, next);
    }
    const Instruction* finish() { return stop(Outcome::Finished, nullptr); }
    /** Makes the statement fail. */
    const Instruction* fail(std::string message);
    /** Called after calls; returns `next`, or null if pause() was called. */
    const Instruction* proceed(const Instruction* next) {
        if (peers_)
            if (const std::string* const lost = peers_->lost()) return loseSight(*lost);
        return goOn(next);
    }
    const Instruction* goOn(const Instruction* next) {
        return pause_.load(std::memory_order_relaxed) ? pauseAt(next) : next;
    }
    /** Called at each round of a loop. */
    const Instruction* goRound(const Instruction* next) {
        if (++rounds_ == round_limit_) return exceed(next);
        return goOn(next);
    }
    const Instruction* enter(Activation& function, const Instruction* returnTo);
    const Instruction* leave();

private:
    const Code& codeOf(const Activation* function) const;
    const Instruction* stop(Outcome outcome, const Instruction* next);
    void show(const Instruction* at);
    const Instruction* pauseAt(const Instruction* next);
    const Instruction* exceed(const Instruction* next);
    const Instruction* loseSight(const std::string& peer);
    const Instruction* fail(const FailedCall& call);
    const Instruction* catchFailure();
    CallPlace placeIn(const Activation* function, const Instruction* at) const;
    const Instruction* interrupt(const char* why);
    template <class Until>
    Outcome execute(Until until);

    const Code& code_;
    std::shared_ptr<const Peers> peers_;
    const Instruction* next_;
    const Instruction* at_ = nullptr;  // being executed
    Activation* function_ = nullptr;   // the innermost that has been entered
    Outcome outcome_ = Outcome::Finished;
    std::atomic<bool> pause_{false};
    std::atomic<const Instruction*> shown_{nullptr};  // in code_; null at the end
    unsigned rounds_ = 0, round_limit_ = 0;
    bool started_ = false, failed_ = false, interrupted_ = false;
    bool idles_ = false;
    bool finishing_ = false;  // pause() was called within a statement
    std::string message_;
    std::unique_ptr<FailedCall> failed_call_;
};

/** A function ready to be executed: its code with arguments and variables. Functions cannot call themselves, so a
    Process needs only one activation of each. */
struct Activation {
    std::string name;
    Code code;
    std::vector<base::DataSourceBase::shared_ptr> arguments;
    base::DataSourceBase::shared_ptr result;  ///< null for void
    const Instruction* returnTo = nullptr;
    Activation* caller = nullptr;
    oroforge::diag::FileName file;
    std::weak_ptr<const std::string> text;  ///< the text of the file, which it does not keep
};

}  // namespace RTT::scripting::detail

#endif
