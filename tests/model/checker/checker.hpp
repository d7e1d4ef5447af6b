// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A model checker for lock-free code: runs a small scenario again and again until every order of its atomic operations,
// and every value that the memory model lets them read, has been tried.
//
// What is modelled
//   * Logical threads are fibers of one system thread. Each atomic operation, mutex operation, futex call, and sleep is
//     one step; what lies between two steps runs undisturbed, and races there are found by vector clocks (Plain<T>,
//     destruction of atomics, use of freed memory), so they need no orders of their own.
//   * Orders are explored depth first. Dynamic partial-order reduction with source sets and sleep sets leaves
//     out those that differ only in the order of independent steps; none that could give another outcome is left out.
//   * Weak memory: each atomic keeps all its values. A load may return an old one unless happens-before, coherence or
//     sequential consistency forbid it; so a missing release, acquire or seq_cst shows. Read-modify-writes read the
//     newest value and continue release sequences; a failing compare-exchange may fail because of an old value.
//
// What is not modelled: loads that return values stored later (no load buffering), an order of modification that differs
// from the order of execution, spurious failures of weak compare-exchanges, spurious wake-ups and time-outs of futexes. The
// number of old values that one thread reads in a run is limited (Options::staleReads), else loops would not end.
#ifndef OROFORGE_MODEL_CHECKER_HPP
#define OROFORGE_MODEL_CHECKER_HPP

#include <cstddef>
#include <functional>
#include <string>

namespace model {

struct Options {
    unsigned staleReads = 1;  ///< old values each thread may read in one run; 0: sequentially consistent
    unsigned long maxExecutions = 3'000'000;  ///< then gives up: Result::complete stays false
    bool reduction = true;                    ///< false: all orders, also of independent steps; to test the checker
};

struct Result {
    bool complete = false;  ///< every order was tried, and none failed
    std::string failure;    ///< what went wrong; empty if nothing did
    std::string trace;      ///< the steps that led there
    unsigned long executions = 0;
};

/** One run of a scenario. */
class Trial {
public:
    /** Adds a thread; at most four. It begins in go(). */
    void thread(std::function<void()> body);
    /** Lets the threads run and waits for their end. They are seen to happen after what came before and before what
        comes after. Once only. */
    void go();
};

/** Explores `scenario`, which must do the same whenever it sees the same values. Stops at the first failure.
    `afterwards` is called, outside the model, after each run that came to its end. */
Result explore(const Options& options, const std::function<void(Trial&)>& scenario,
               const std::function<void()>& afterwards = nullptr);

/** Within a scenario: fails the run. Does not return if `holds` is false. */
void require(bool holds, const char* what);

/** Within a scenario: gives each logical thread a copy of its own of a thread-local variable, all zero at first. */
void threadLocal(void* variable, std::size_t size);

/** Within a scenario: how often a futex was asked to wake somebody, and to let somebody sleep. */
struct FutexCalls {
    unsigned wakes = 0, waits = 0;
};
FutexCalls futexCalls();

/** Number of blocks of memory allocated in this run and not freed. */
std::size_t liveBlocks();

/** The number of the logical thread, from 0 in order of creation. */
unsigned self();

/** A planted fault, see plant.cmake: true while `explore` is to catch it. */
const bool& faultSwitch(const char* name);
#define MODEL_FAULT(name)                                       \
    ([] {                                                       \
        static const bool& planted = model::faultSwitch(#name); \
        return planted;                                         \
    }())
void plantFault(const char* name, bool on);

}  // namespace model

#endif
