// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What the parts of the checker know of each other.
#ifndef OROFORGE_MODEL_INTERNAL_HPP
#define OROFORGE_MODEL_INTERNAL_HPP

#include <model/checker/atomic.hpp>
#include <model/checker/checker.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace model {

constexpr unsigned kThreads = 5;  // the scenario itself is number 0
constexpr std::uint32_t kNever = ~std::uint32_t(0);

struct Clock {
    std::array<std::uint32_t, kThreads> at{};
    void join(const Clock& other) {
        for (unsigned t = 0; t < kThreads; ++t) at[t] = std::max(at[t], other.at[t]);
    }
    bool covers(const Clock& other) const {
        for (unsigned t = 0; t < kThreads; ++t)
            if (at[t] < other.at[t]) return false;
        return true;
    }
};

struct Step {
    enum Kind : std::uint8_t { Begin, Load, Change, Lock, Unlock, Wait, Resume, Wake, Yield, Barrier };
    Kind kind = Begin;
    std::uint32_t object = kNever;
};

/** Objects are known by the address they have in this run and by a number. */
struct Object {
    struct Value {
        std::uint64_t word;
        std::uint8_t thread;
        bool sequential;
        std::uint32_t time;                        // in its thread
        Clock happens, view;                       // what an acquire load that reads it gets
        std::array<std::uint32_t, kThreads> seen;  // when each thread first read it
    };
    const void* at = nullptr;
    std::vector<Value> values;     // of an atomic, in order of modification
    Clock used;                    // last access of each thread
    Clock written;                 // plain: last change of each thread
    Clock released, releasedView;  // mutexes and counts: what the next owner gets
    int owner = -1;                // of a mutex
    bool dead = false;
};

/** A logical thread as the memory model sees it. */
struct Thread {
    Clock happens;  // what happens before its next step
    Clock view;     // the same, and what barriers have made visible
    unsigned staleReads = 0;
    bool stale = false;  // read an old value since it last slept
};

// scheduler.cpp
/** Waits until the calling thread may perform `step`. */
void perform(const Step& step);
/** One of `count` ways to go on. */
unsigned choose(unsigned count);
Thread& current();
Thread& threadAt(unsigned number);
unsigned staleLimit();
std::uint32_t runNumber();
/** True inside a scenario; the checker's own code has it false, so that its memory is not the scenario's. */
extern bool inScenario;
[[noreturn]] void fail(const char* what);  // no string: the frames of an abandoned run are not unwound
void note(const Step& step, std::uint64_t value, std::memory_order order);
/** Something was stored: threads that sleep may look again. */
void noteChange();
void noteWait();
void sleepOn(std::uint32_t object);
void wakeSleepers(std::uint32_t object, unsigned count);

// memory.cpp
Object& object(std::uint32_t index);
void forgetObjects();
bool mutexHeld(std::uint32_t index);

// arena.cpp
void resetArena();
/** True unless `at` lies in freed memory of the scenario. */
bool isLive(const void* at);

/** The checker's own code: entered from a scenario, left to it. */
class Outside {
public:
    Outside() : was_(inScenario) { inScenario = false; }
    ~Outside() { inScenario = was_; }
    Outside(const Outside&) = delete;
    Outside& operator=(const Outside&) = delete;
    bool inRun() const { return was_; }

private:
    bool was_;
};

}  // namespace model

#endif
