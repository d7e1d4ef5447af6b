// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The members of a running chain. A roster is never changed but for its measurements: another one replaces it.
#ifndef OROFORGE_CHAIN_ROSTER_HPP
#define OROFORGE_CHAIN_ROSTER_HPP

#include "peers.hpp"
#include "settings.hpp"
#include "times.hpp"

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace OCL::chain {

/** What is measured of a member. The thread of the chain writes. */
struct Measured {
    Times times;
    Shown<unsigned> overruns, failures, leftOut;
    Shown<bool> threw;  // the last failure was an exception
    unsigned told = 0;  // failures that were logged; guarded by the mutex of the chain
};

/** What is measured of the cycles. */
struct MeasuredCycles {
    Times durations, jitter;
    Shown<unsigned> overruns;
};

/** The last times between two cycles, in ns. */
class RecentPeriods {
public:
    explicit RecentPeriods(std::size_t size) : size_(size), ring_(new Shown<std::int64_t>[size]) {}
    void add(std::int64_t period) noexcept {
        const std::uint64_t at = count_();
        ring_[at % size_].set(period);
        count_.set(at + 1);
    }
    /** Those that are there, in no order. */
    std::vector<std::int64_t> all() const;
    std::size_t size() const { return size_; }

private:
    const std::size_t size_;
    const std::unique_ptr<Shown<std::int64_t>[]> ring_;
    Shown<std::uint64_t> count_;
};

struct Member {
    Peer peer;
    Divider divider;
    std::int64_t budget = 0;  // ns; 0 for none
    std::shared_ptr<Measured> measured;
    int row = -1;            // in the sample of the port `statistics`
    unsigned countdown = 0;  // cycles until it is due; for the thread of the chain
};

struct Roster {
    std::vector<Member> members;
    std::shared_ptr<MeasuredCycles> cycles = std::make_shared<MeasuredCycles>();
    std::shared_ptr<RecentPeriods> periods;
    Settings settings;
    Roster* next = nullptr;  // of the replaced ones
};

/** Hands rosters to the thread of the chain, and takes replaced ones back. */
class RosterExchange {
public:
    RosterExchange() = default;
    ~RosterExchange();
    RosterExchange(const RosterExchange&) = delete;
    RosterExchange& operator=(const RosterExchange&) = delete;

    /** The roster for this cycle; null before the first publish(). For the thread of the chain; real-time safe. */
    Roster* take() noexcept;
    /** The one of the last take(). */
    Roster* current() const noexcept { return current_; }
    /** One thread at a time; destroys what is not in use any more. */
    void publish(std::unique_ptr<Roster> roster);

private:
    void destroyReplaced();

    Roster* current_ = nullptr;
    std::atomic<Roster*> next_{nullptr}, replaced_{nullptr};
};

}  // namespace OCL::chain

#endif
