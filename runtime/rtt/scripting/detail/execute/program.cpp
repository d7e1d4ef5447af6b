// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/execute/program.hpp>

#include <rtt/ExecutionEngine.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/os/MutexLock.hpp>
#include <rtt/scripting/detail/execute/log_diagnostics.hpp>

#include <diag/print.hpp>

#include <algorithm>

namespace RTT::scripting::detail {

namespace {

// The word state_ has a state and the requests for the next step. Only the engine's thread removes requests; other
// threads add them. Each does so with one atomic operation on the value that it has read.
enum State : unsigned { Stopped, Paused, Running, Failed };
constexpr unsigned kState = 3;
constexpr unsigned kRestart = 4;  // begin with the first statement
constexpr unsigned kPause = 8;    // become Paused
constexpr unsigned kStep = 16;    // execute a statement, and stay Paused

State stateOf(unsigned word) { return static_cast<State>(word & kState); }
/** True if there is nothing to do and no request. */
bool isAtRest(unsigned word) { return word == Stopped || word == Paused || word == Failed; }

}  // namespace

Program::Program(std::string name, std::string component, Text text, std::unique_ptr<Code> code, RoundLimit limit,
                 std::shared_ptr<const Peers> peers)
    : name_(std::move(name)),
      component_(std::move(component)),
      text_(std::move(text)),
      code_(std::move(code)),
      limit_(std::move(limit)),
      process_(*code_),
      state_(Stopped) {
    process_.watch(std::move(peers));
}

Program::~Program() {
    if (ExecutionEngine* const engine = getEngine()) engine->removeFunction(this);
}

/** Changes the state by `rule`, which gives the new value for the present one; no change if it gives the same value or
    false. */
template <class Rule>
bool Program::change(Rule rule) {
    if (!isLoaded()) return false;
    unsigned now = state_.load(), next = now;
    do {
        next = now;
        if (!rule(now, next)) return false;
    } while (!state_.compare_exchange_weak(now, next));
    if (!isAtRest(next)) wake();
    return true;
}

bool Program::isIdle() const { return isAtRest(state_.load()); }

bool Program::start() {
    return change([](unsigned now, unsigned& next) {
        switch (stateOf(now)) {
            case Stopped: next = Running | kRestart; return true;
            case Paused: next = Running; return true;
            case Running:
                next = now & ~(kPause | kStep);
                return (now & kPause) != 0;  // cancels a pause that has not taken effect
            case Failed: break;
        }
        return false;
    });
}

bool Program::pause() {
    const bool accepted = change([](unsigned now, unsigned& next) {
        if (stateOf(now) == Stopped || stateOf(now) == Running) next = now | kPause;
        if (stateOf(now) == Failed) next = Paused;
        return true;
    });
    if (accepted) process_.pause();
    return accepted;
}

bool Program::step() {
    return change([](unsigned now, unsigned& next) {
        next = now | kStep;
        return now != next && (stateOf(now) == Paused || (now & kPause));
    });
}

bool Program::stop() {
    const bool accepted = change([](unsigned, unsigned& next) {
        next = Stopped;
        return true;
    });
    if (accepted) process_.pause();
    return accepted;
}

ProgramInterface::ProgramStatus Program::getStatus() const {
    switch (stateOf(state_.load())) {
        case Stopped: return Status::stopped;
        case Paused: return Status::paused;
        case Running: return Status::running;
        case Failed: return Status::error;
    }
    return Status::unknown;
}

int Program::getLineNumber() const {
    if (isStopped()) return 0;
    const unsigned line = process_.line();
    return static_cast<int>(line != 0 ? line : code_->placeOf(code_->begin()).line);
}

std::string Program::getError() const {
    if (!inError()) return {};
    const os::MutexLock lock(error_lock_);
    return error_;
}

bool Program::execute() {
    const auto alive = weak_from_this().lock();  // because one of its own statements may unload it
    while (executeOnce()) {
    }
    return true;
}

/** True if there is more to do in this step. */
bool Program::executeOnce() {
    unsigned now = state_.load();
    const auto become = [&](unsigned next) { return state_.compare_exchange_strong(now, next); };
    const unsigned paused = Paused | (now & kStep);
    if ((stateOf(now) == Stopped && (now & kPause)) || (now & kRestart)) {
        if (become(now & kRestart ? now & ~kRestart : paused)) process_.restart();
        return true;
    }
    if (now & kPause) {
        become(paused);
        return true;
    }
    if (now != Running && now != (Paused | kStep)) return false;
    if (process_.failed()) process_.retry();
    process_.setRoundLimit(limit_ ? limit_->rvalue() : 0);
    return settle(now == Running ? process_.run() : process_.runStatement());
}

/** Sets the new state, unless another thread stopped or restarted the program meanwhile. */
bool Program::settle(Process::Outcome outcome) {
    if (outcome == Process::Outcome::Failed) reportFailure();
    unsigned now = state_.load(), next = now;
    do {
        const State state = stateOf(now);
        if (state == Stopped || state == Failed || (now & kRestart)) return false;
        switch (outcome) {
            case Process::Outcome::Finished: next = Stopped; break;
            case Process::Outcome::Failed: next = Failed; break;
            // If the pause was cancelled meanwhile, the program continues at once.
            case Process::Outcome::Paused:
            case Process::Outcome::Yielded: next = now & kPause ? Paused | (now & kStep) : state; break;
        }
    } while (!state_.compare_exchange_weak(now, next));
    return outcome == Process::Outcome::Paused && next != Paused;
}

void Program::reportFailure() {
    oroforge::diag::Sink sink;
    process_.report(sink, text_.file, "program '" + name_ + "' of component '" + component_ + "'");
    oroforge::diag::SourceCache lines;
    const std::string text = text_.at.line == 0 ? ""
                                                : std::string(text_.at.line - 1, '\n') +
                                                      std::string(text_.at.column - 1, ' ') + text_.letters;
    if (process_.failedCall())
        process_.failedCall()->addLines(lines, text_.file, text);
    else if (!text.empty())
        lines.add(text_.file, text);
    logDiagnostics(sink, lines);
    const os::MutexLock lock(error_lock_);
    error_ = oroforge::diag::toString(sink.all().front());
}

ProgramInterfacePtr makeProgram(const ast::Program& tree, const SourceFile& file, std::string text,
                                const CompileContext& where) {
    const std::string& name = tree.name.text;
    CompileContext here = where;
    here.peers = std::make_shared<Peers>();
    Compiler compiler(here);
    std::unique_ptr<Code> code = compiler.program(tree.body, "program '" + name + "'", file.scope);
    if (!code) return nullptr;
    Program::Text source{where.file, std::move(text), {}};
    const std::size_t begin = file.text.find(source.letters);
    if (begin != std::string::npos) {
        const std::string before = file.text.substr(0, begin);
        const auto lines = std::count(before.begin(), before.end(), '\n');
        const std::size_t newline = before.rfind('\n');
        source.at = {static_cast<unsigned>(lines) + 1,
                     static_cast<unsigned>(begin - (newline == std::string::npos ? 0 : newline + 1)) + 1};
    }
    return boost::make_shared<Program>(name, where.component->getName(), std::move(source), std::move(code),
                                       where.roundLimit, here.peers);
}

namespace {

/** Code that calls an operation of the service keeps this but not the program, because programs may command each
    other. */
template <class Function>
struct OfProgram {
    boost::weak_ptr<ProgramInterface> program;
    Function function;
    bool operator()() const {
        const ProgramInterfacePtr present = program.lock();
        return present && ((*present).*function)();
    }
};

}  // namespace

Service::shared_ptr makeProgramService(const ProgramInterfacePtr& program, TaskContext& owner) {
    const auto service = boost::make_shared<Service>(program->getName(), &owner);
    service->doc("The program '" + program->getName() + "' of a script.");
    const auto add = [&](const char* name, auto function) -> auto& {
        auto& operation = service->addOperation(name, OfProgram<decltype(function)>{program, function});
        // C++ code may call it with the program as first argument.
        service->addMemberOverloads<ProgramInterface>(name, function);
        return operation;
    };
    add("start", &ProgramInterface::start)
        .doc(
            "Runs it from its first statement, or resumes it if it is paused. False if it runs already or has failed.");
    add("pause", &ProgramInterface::pause)
        .doc("Pauses it before its next statement; if it is stopped, before its first.");
    add("step", &ProgramInterface::step)
        .doc("Executes one statement. False if it is not paused, or has not done the last one yet.");
    add("stop", &ProgramInterface::stop).doc("Stops it.");
    add("isRunning", &ProgramInterface::isRunning).doc("Does it execute statements?");
    add("isPaused", &ProgramInterface::isPaused).doc("Does it wait for start() or step()?");
    add("inError", &ProgramInterface::inError).doc("Has it failed, and not been stopped since?");
    return service;
}

}  // namespace RTT::scripting::detail
