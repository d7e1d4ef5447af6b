// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The execution of a Code, which can be interrupted between statements and goes on where it was.
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

/** Belongs to one thread at a time, except where said. Nothing here allocates, locks or looks up names, unless an operation
    that is called does, or something fails (the message). */
class Process {
public:
    enum class Outcome {
        Finished,  ///< the end was reached, or a `return`
        Yielded,   ///< wants to go on in the next step
        Paused,    ///< pause() was called; goes on with run()
        Failed     ///< see message(); stays at the statement that failed
    };

    /** At the beginning of `code`, which must outlive this. */
    explicit Process(const Code& code);
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /** Executes statements until one of the outcomes above. */
    Outcome run();
    /** As run(), for what has to be there at once: goes on where it yields; Failed if there is no end to that. */
    Outcome runToEnd();
    /** After Yielded: at a `nothing` or a command, by which scripts wait as long as it takes. */
    bool idles() const { return idles_; }
    /** Executes one statement. Yielded if there are more. */
    Outcome runStatement();
    /** Back to the beginning; clears a failure. Variables keep their values. */
    void restart();
    /** After Failed: has run() execute the failed statement again from its beginning, in the function it is in. */
    void retry();
    /** True from the first run() until Finished, or restart(). */
    bool started() const { return started_; }
    /** Has run() return with Paused after the statement that is being executed; any thread. */
    void pause() { pause_.store(true, std::memory_order_relaxed); }
    /** The statement that comes next, or failed; {0, 0} if there is none. Any thread: as of the last time it stopped. */
    ast::Place place() const;
    unsigned line() const { return place().line; }
    /** Why it failed, without place. */
    const std::string& message() const { return message_; }
    bool failed() const { return failed_; }
    /** The call that failed it; null: something else. */
    const FailedCall* failedCall() const { return failed_call_.get(); }
    /** After Failed: why, where, and what was called where. `whole`: "program 'p'"; empty: a statement of that file. */
    void report(oroforge::diag::Sink& sink, const oroforge::diag::FileName& file, const std::string& whole) const;
    /** It failed because the thread was asked to end what it does, see internal::Interruption. */
    bool interrupted() const { return interrupted_; }

    /** From now on it fails, and nothing catches that, instead of going on after one of these was destroyed: looked at
        when it begins, and after calls. */
    void watch(std::shared_ptr<const Peers> peers) { peers_ = std::move(peers); }

    /** How often loops may go round within one run(); 0: no limit. Beyond that it fails. */
    void setRoundLimit(unsigned limit) { round_limit_ = limit; }

    // -- For instructions -----------------------------------------------------------------------------------
    /** To go on with `next` in the next step. */
    const Instruction* yieldTo(const Instruction* next) {
        idles_ = false;
        return stop(Outcome::Yielded, next);
    }
    /** The same: it waits for others. */
    const Instruction* idleTo(const Instruction* next) {
        idles_ = true;
        return stop(Outcome::Yielded, next);
    }
    const Instruction* finish() { return stop(Outcome::Finished, nullptr); }
    /** The statement fails. */
    const Instruction* fail(std::string message);
    /** Called after calls: `next`, or null if pause() was called. */
    const Instruction* proceed(const Instruction* next) {
        if (peers_)
            if (const std::string* const lost = peers_->lost()) return loseSight(*lost);
        return goOn(next);
    }
    const Instruction* goOn(const Instruction* next) {
        return pause_.load(std::memory_order_relaxed) ? pauseAt(next) : next;
    }
    /** Called where a loop goes round. */
    const Instruction* goRound(const Instruction* next) {
        if (++rounds_ == round_limit_) return exceed();
        return goOn(next);
    }
    const Instruction* enter(Activation& function, const Instruction* returnTo);
    const Instruction* leave();

private:
    const Code& codeOf(const Activation* function) const;
    const Instruction* stop(Outcome outcome, const Instruction* next);
    void show(const Instruction* at);
    const Instruction* pauseAt(const Instruction* next);
    const Instruction* exceed();
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
    std::atomic<const Instruction*> shown_{nullptr};  // of code_; null: at the end
    unsigned rounds_ = 0, round_limit_ = 0;
    bool started_ = false, failed_ = false, interrupted_ = false;
    bool idles_ = false;
    bool finishing_ = false;  // a statement within which pause() was called
    std::string message_;
    std::unique_ptr<FailedCall> failed_call_;
};

/** What a function needs while it is executed: its code, with arguments and variables. Functions cannot call themselves, so
    that a Process needs one activation of each function it can reach. */
struct Activation {
    std::string name;
    Code code;
    std::vector<base::DataSourceBase::shared_ptr> arguments;
    base::DataSourceBase::shared_ptr result;  ///< null for void
    const Instruction* returnTo = nullptr;
    Activation* caller = nullptr;
    oroforge::diag::FileName file;
    std::weak_ptr<const std::string> text;  ///< of the file, which it does not keep
};

}  // namespace RTT::scripting::detail

#endif
