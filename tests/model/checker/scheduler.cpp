// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Runs: threads, their steps, what they wait for, and how a run ends.
#include <model/checker/explorer.hpp>
#include <model/checker/fibers.hpp>

#include <cstdlib>
#include <cstring>
#include <sstream>

namespace model {

namespace {

constexpr std::size_t kMostSteps = 4000;

struct Logical {
    std::function<void()> body;
    Thread memory;
    bool finished = false, woken = false;
    bool slept = false;                  // in yield(), at least once
    unsigned long seen = 0, stored = 0;  // changes by others up to the last yield(); changes by this one
};

struct Note {
    unsigned thread;
    Step step;
    std::uint64_t value;
    std::memory_order order;
};

struct State {
    explicit State(const Options& o) : explorer(o.reduction), options(o) {}
    Fibers fibers{kThreads};
    Explorer explorer;
    const Options options;
    const std::function<void(Trial&)>* scenario = nullptr;
    std::vector<Logical> threads;
    Explorer::Pending pending;
    std::vector<unsigned> sleepers;  // on futexes, in order
    std::vector<Note> notes;
    std::string failure;
    unsigned long changes = 0;
    std::uint32_t run = 0;
    FutexCalls calls;
    bool ended = false;
};
State* state = nullptr;
std::uint32_t runs = 0;

bool enabled(unsigned number) {
    const Logical& thread = state->threads[number];
    if (thread.finished) return false;
    switch (state->pending[number].kind) {
        case Step::Lock: return !mutexHeld(state->pending[number].object);
        case Step::Resume: return thread.woken;
        case Step::Yield: return !thread.slept || thread.memory.stale || state->changes - thread.stored > thread.seen;
        default: return true;
    }
}

[[noreturn]] void leave() {
    inScenario = false;
    state->fibers.leave();
    std::abort();
}

/** Goes on with whoever's turn it is. */
void reschedule() {
    Explorer::Set able = 0;
    bool all = true;
    for (unsigned t = 1; t < state->threads.size(); ++t) {
        if (enabled(t)) able = static_cast<Explorer::Set>(able | 1u << t);
        all = all && state->threads[t].finished;
    }
    if (all) return state->fibers.switchTo(0);
    if (!able) fail("no thread can go on: a lost wake-up or a deadlock");
    if (state->explorer.depth() == kMostSteps) fail("the run does not end");
    const int next = state->explorer.next(able, state->pending, self());
    if (next < 0) leave();
    state->fibers.switchTo(static_cast<unsigned>(next));
}

void fiberBody(unsigned number) {
    if (number == 0) {
        Trial trial;
        inScenario = true;
        (*state->scenario)(trial);
        state->ended = true;
    } else {
        inScenario = true;
        state->threads[number].body();
    }
    inScenario = false;
    if (number == 0) leave();
    state->threads[number].finished = true;
    reschedule();
}

const char* name(Step::Kind kind) {
    static const char* const names[] = {"begins",         "reads",         "changes", "locks",  "unlocks",
                                        "waits on futex", "wakes up from", "wakes",   "sleeps", "membarrier"};
    return names[kind];
}

std::string traceText() {
    static const char* const orders[] = {"relaxed", "consume", "acquire", "release", "acq_rel", "seq_cst"};
    std::ostringstream out;
    for (const Note& note : state->notes) {
        out << "  T" << note.thread << ' ' << name(note.step.kind);
        if (note.step.object != kNever)
            out << " #" << note.step.object << " = 0x" << std::hex << note.value << std::dec << ' '
                << orders[static_cast<int>(note.order)];
        out << '\n';
    }
    return out.str();
}

void oneRun() {
    State& s = *state;
    s.run = ++runs;
    forgetObjects();
    resetArena();
    s.explorer.rewind();
    s.threads.assign(1, Logical());
    s.threads.reserve(kThreads);
    s.sleepers.clear();
    s.notes.clear();
    s.changes = 0;
    s.calls = FutexCalls();
    s.ended = false;
    s.fibers.run(0, &fiberBody);
    s.threads.clear();
}

}  // namespace

void perform(const Step& step) {
    if (self() == 0) return;
    state->pending[self()] = step;
    reschedule();
}

unsigned choose(unsigned count) { return self() == 0 ? 0 : state->explorer.choose(count); }
Thread& current() { return state->threads[self()].memory; }
Thread& threadAt(unsigned number) {
    static Thread none;
    return number < state->threads.size() ? state->threads[number].memory : (none = Thread());
}
unsigned staleLimit() { return state->options.staleReads; }
std::uint32_t runNumber() { return state->run; }
unsigned self() { return state->fibers.current(); }
FutexCalls futexCalls() { return state->calls; }

void fail(const char* what) {
    state->failure = what;
    leave();
}

void require(bool holds, const char* what) {
    if (holds) return;
    inScenario = false;
    fail(what);
}

void threadLocal(void* variable, std::size_t size) {
    const Outside outside;
    state->fibers.threadLocal(variable, size);
}

void note(const Step& step, std::uint64_t value, std::memory_order order) {
    state->notes.push_back({self(), step, value, order});
}

void noteChange() {
    ++state->changes;
    ++state->threads[self()].stored;
}

void yield() {
    const Outside outside;
    if (!outside.inRun()) return;
    const Step step{Step::Yield, kNever};
    perform(step);
    Logical& thread = state->threads[self()];
    thread.slept = true;
    thread.seen = state->changes - thread.stored;
    thread.memory.stale = false;
    note(step, 0, std::memory_order_relaxed);
}

void noteWait() { ++state->calls.waits; }

void sleepOn(std::uint32_t object) {
    state->threads[self()].woken = false;
    state->pending[self()] = {Step::Resume, object};
    state->sleepers.push_back(self());
    perform({Step::Resume, object});
    note({Step::Resume, object}, 0, std::memory_order_relaxed);
}

void wakeSleepers(std::uint32_t object, unsigned count) {
    ++state->calls.wakes;
    std::vector<unsigned>& all = state->sleepers;
    for (std::size_t i = 0; i < all.size() && count > 0;) {
        if (state->pending[all[i]].object != object) {
            ++i;
            continue;
        }
        state->threads[all[i]].woken = true;
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
        --count;
    }
}

void Trial::thread(std::function<void()> body) {
    const Outside outside;
    if (state->threads.size() == kThreads) fail("too many threads");
    state->threads.emplace_back();
    state->threads.back().body = std::move(body);
}

void Trial::go() {
    const Outside outside;
    const Thread before = current();
    for (unsigned t = 1; t < state->threads.size(); ++t) {
        state->threads[t].memory = before;
        state->pending[t] = Step();
    }
    reschedule();
    for (unsigned t = 1; t < state->threads.size(); ++t) {
        current().happens.join(threadAt(t).happens);
        current().view.join(threadAt(t).view);
    }
    current().view.join(current().happens);
}

Result explore(const Options& options, const std::function<void(Trial&)>& scenario,
               const std::function<void()>& afterwards) {
    State s(options);
    state = &s;
    s.scenario = &scenario;
    Result result;
    // The first run of a scenario in a process makes what is static. Its objects have other numbers than those of the next
    // runs, and the explorer would not see which of their steps depend on each other. So it does not count.
    oneRun();
    if (s.failure.empty()) s.explorer = Explorer(options.reduction);
    do {
        if (result.executions == options.maxExecutions) break;
        if (s.failure.empty()) oneRun();
        ++result.executions;
        if (!s.failure.empty()) {
            result.failure = s.failure;
            result.trace = traceText();
            break;
        }
        if (s.ended && afterwards) afterwards();
    } while (result.complete = !s.explorer.advance(), !result.complete);
    state = nullptr;
    return result;
}

namespace {
struct Fault {
    char name[48];
    bool on;
};
Fault faults[64];
std::size_t faultCount = 0;

Fault& fault(const char* name) {
    for (std::size_t i = 0; i < faultCount; ++i)
        if (std::strcmp(faults[i].name, name) == 0) return faults[i];
    if (faultCount == sizeof faults / sizeof faults[0] || std::strlen(name) >= sizeof faults[0].name) std::abort();
    std::strcpy(faults[faultCount].name, name);
    return faults[faultCount++];
}
}  // namespace

const bool& faultSwitch(const char* name) { return fault(name).on; }
void plantFault(const char* name, bool on) { fault(name).on = on; }

}  // namespace model
