// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The checker against programs whose outcomes are known.
#include <model/expect.hpp>
#include <model/checker/atomic.hpp>

#include <array>
#include <bitset>
#include <random>
#include <set>

namespace {

using model::Atomic;
using model::explore;
using model::Options;
using model::Plain;
using model::require;
using model::Result;
using model::Scenario;
using model::Trial;
constexpr std::memory_order relaxed = std::memory_order_relaxed, acquire = std::memory_order_acquire,
                            release = std::memory_order_release, sequential = std::memory_order_seq_cst;

Scenario messagePassing(std::memory_order store, std::memory_order load) {
    return [=](Trial& trial) {
        Plain<int> data(0);
        Atomic<int> ready(0);
        trial.thread([&] {
            data = 1;
            ready.store(1, store);
        });
        trial.thread([&] {
            if (ready.load(load)) require(data == 1, "old data");
        });
        trial.go();
    };
}

TEST(ModelChecker, messages_need_release_and_acquire) {
    EXPECT_TRUE(model::holds(messagePassing(release, acquire)));
    EXPECT_FALSE(model::holds(messagePassing(relaxed, acquire)));
    EXPECT_FALSE(model::holds(messagePassing(release, relaxed)));
}

/** Both loads read 0? */
bool storeBuffering(std::memory_order order, unsigned stale) {
    bool seen = false;
    const Result result = explore({stale}, [&](Trial& trial) {
        Atomic<int> x(0), y(0);
        int a = 1, b = 1;
        trial.thread([&] {
            x.store(1, order);
            a = y.load(order);
        });
        trial.thread([&] {
            y.store(1, order);
            b = x.load(order);
        });
        trial.go();
        seen = seen || (a == 0 && b == 0);
    });
    EXPECT_TRUE(result.complete) << result.failure;
    return seen;
}

TEST(ModelChecker, only_sequential_consistency_forbids_store_buffering) {
    EXPECT_FALSE(storeBuffering(sequential, 2));
    EXPECT_TRUE(storeBuffering(relaxed, 2));
    EXPECT_FALSE(storeBuffering(relaxed, 0));
}

TEST(ModelChecker, a_barrier_in_one_thread_makes_up_for_plain_stores_in_the_other) {
    const auto scenario = [](bool barrier) {
        return [=](Trial& trial) {
            Atomic<int> x(0), y(0);
            int a = 1, b = 1;
            trial.thread([&] {
                x.store(1, relaxed);
                a = y.load(relaxed);
            });
            trial.thread([&] {
                y.store(1, relaxed);
                if (barrier) model::membarrier();
                b = x.load(relaxed);
            });
            trial.go();
            require(a == 1 || b == 1, "both read the old value");
        };
    };
    EXPECT_TRUE(model::holds(scenario(true), {2}));
    EXPECT_FALSE(model::holds(scenario(false), {2}));
}

/** What x = 2 x + i in three threads can lead to, by trying all orders of the loads and stores. */
void allOutcomes(int x, std::array<int, 3> loaded, std::array<int, 3> steps, std::bitset<32>& outcomes) {
    bool end = true;
    for (std::size_t t = 0; t < 3; ++t) {
        if (steps[t] == 2) continue;
        end = false;
        auto nextLoaded = loaded, nextSteps = steps;
        if (nextSteps[t]++ == 0) nextLoaded[t] = x;
        allOutcomes(nextSteps[t] == 2 ? loaded[t] * 2 + static_cast<int>(t) + 1 : x, nextLoaded, nextSteps, outcomes);
    }
    if (end) outcomes.set(static_cast<std::size_t>(x));
}

TEST(ModelChecker, all_outcomes_of_racing_changes_are_seen) {
    std::bitset<32> outcomes, expected;
    const Result result = explore({0, 1000}, [&](Trial& trial) {
        Atomic<int> x(0);
        for (int i = 1; i <= 3; ++i) trial.thread([&x, i] { x.store(x.load() * 2 + i); });
        trial.go();
        outcomes.set(static_cast<std::size_t>(x.load()));
    });
    EXPECT_TRUE(result.complete);
    allOutcomes(0, {}, {}, expected);
    EXPECT_EQ(outcomes, expected);
}

TEST(ModelChecker, independent_steps_are_not_tried_in_every_order) {
    const Result result = explore({}, [](Trial& trial) {
        Atomic<int> values[4] = {};
        for (Atomic<int>& value : values)
            trial.thread([&value] {
                for (int i = 0; i < 10; ++i) value.fetch_add(1);
            });
        trial.go();
    });
    EXPECT_TRUE(result.complete);
    EXPECT_EQ(result.executions, 1u);
}

/** A program of three threads with `length` random steps on three atomics; what all its loads may give together. */
std::set<std::uint64_t> outcomesOf(unsigned seed, bool reduction, unsigned stale, unsigned long& executions) {
    constexpr std::size_t length = 3;
    struct Instruction {
        unsigned kind, object, order;
    };
    std::array<std::array<Instruction, length>, 3> program;
    std::mt19937 generator(seed);
    const auto random = [&generator](unsigned below) { return static_cast<unsigned>(generator() % below); };
    for (auto& thread : program)
        for (Instruction& one : thread) one = {random(4), random(3), random(3)};
    std::set<std::uint64_t> outcomes;
    static std::uint64_t outcome;
    Options options;
    options.staleReads = stale;
    options.reduction = reduction;
    const Scenario scenario = [&](Trial& trial) {
        Atomic<unsigned> objects[3] = {};
        std::array<std::uint64_t, 3> seen{};
        for (std::size_t t = 0; t < 3; ++t)
            trial.thread([&, t] {
                for (std::size_t i = 0; i < length; ++i) {
                    const Instruction& one = program[t][i];
                    Atomic<unsigned>& object = objects[one.object];
                    const unsigned value = static_cast<unsigned>(t * length + i + 1);
                    unsigned got = 0;
                    switch (one.kind) {
                        case 0:
                            object.store(value, one.order == 0 ? relaxed : one.order == 1 ? release : sequential);
                            break;
                        case 1:
                            got = object.exchange(value, one.order == 0 ? relaxed : std::memory_order_acq_rel);
                            break;
                        default: got = object.load(one.order == 0 ? relaxed : one.order == 1 ? acquire : sequential);
                    }
                    seen[t] = seen[t] * 16 + got;
                }
            });
        trial.go();
        outcome = 0;
        for (std::size_t t = 0; t < 3; ++t) outcome = (outcome << 12 | seen[t]) << 4 | objects[t].load();
    };
    const Result result = explore(options, scenario, [&] { outcomes.insert(outcome); });
    EXPECT_TRUE(result.complete) << result.failure;
    executions += result.executions;
    return outcomes;
}

TEST(ModelChecker, reduction_loses_no_outcome) {
    unsigned long reduced = 0, full = 0;
    for (unsigned seed = 0; seed < 40; ++seed)
        for (unsigned stale = 0; stale < 2; ++stale)
            ASSERT_EQ(outcomesOf(seed, true, stale, reduced), outcomesOf(seed, false, stale, full))
                << "seed " << seed << ", stale " << stale;
    EXPECT_LT(reduced * 3, full);
}

TEST(ModelChecker, mutexes_exclude_and_deadlocks_are_found) {
    const auto scenario = [](bool sameOrder) {
        return [=](Trial& trial) {
            model::Mutex a, b;
            Plain<int> data(0);
            trial.thread([&] {
                a.lock();
                b.lock();
                data = data + 1;
                b.unlock();
                a.unlock();
            });
            trial.thread([&] {
                (sameOrder ? a : b).lock();
                (sameOrder ? b : a).lock();
                data = data + 1;
                (sameOrder ? b : a).unlock();
                (sameOrder ? a : b).unlock();
            });
            trial.go();
            require(data == 2, "lost update");
        };
    };
    EXPECT_TRUE(model::holds(scenario(true)));
    EXPECT_FALSE(model::holds(scenario(false)));
}

TEST(ModelChecker, a_lost_wake_up_is_found) {
    const auto scenario = [](bool wakeFirst) {
        return [=](Trial& trial) {
            Atomic<std::uint32_t> word(0);
            trial.thread([&] {
                while (word.load() == 0) model::futexWait(word, 0);
            });
            trial.thread([&] {
                if (wakeFirst) model::futexWake(word, 1);
                word.store(1);
                if (!wakeFirst) model::futexWake(word, 1);
            });
            trial.go();
        };
    };
    EXPECT_TRUE(model::holds(scenario(false)));
    EXPECT_FALSE(model::holds(scenario(true)));
}

TEST(ModelChecker, use_after_free_and_freeing_twice_are_found) {
    const auto scenario = [](std::memory_order order, int extra) {
        return [=](Trial& trial) {
            struct Counted {
                Atomic<int> count{2};
                Plain<int> data{0};
            };
            Counted* object = new Counted;
            for (int t = 0; t < 2; ++t)
                trial.thread([=] {
                    (void)object->data.get();
                    if (object->count.fetch_sub(1, order) == 1 + extra * t) delete object;
                });
            trial.go();
        };
    };
    EXPECT_TRUE(model::holds(scenario(std::memory_order_acq_rel, 0)));
    EXPECT_FALSE(model::holds(scenario(relaxed, 0)));
    EXPECT_FALSE(model::holds(scenario(std::memory_order_acq_rel, 1)));
}

TEST(ModelChecker, threads_have_their_own_thread_locals) {
    static thread_local int variable = 7;
    EXPECT_TRUE(model::holds([](Trial& trial) {
        model::threadLocal(&variable, sizeof variable);
        Atomic<int> x(0);
        for (int t = 1; t <= 2; ++t)
            trial.thread([&x, t] {
                require(variable == 0, "not fresh");
                variable = t;
                x.fetch_add(1);
                require(variable == t, "not its own");
            });
        trial.go();
    }));
}

TEST(ModelChecker, sleeping_loops_end_when_somebody_stores) {
    EXPECT_TRUE(model::holds([](Trial& trial) {
        Atomic<int> x(0);
        trial.thread([&] {
            while (x.load(acquire) != 2) model::yield();
        });
        trial.thread([&] {
            x.store(1, release);
            x.store(2, release);
        });
        trial.go();
    }));
    EXPECT_FALSE(model::holds([](Trial& trial) {
        Atomic<int> x(0);
        trial.thread([&] {
            while (x.load(acquire) != 2) model::yield();
        });
        trial.thread([&] { x.store(1, release); });
        trial.go();
    }));
}

}  // namespace
