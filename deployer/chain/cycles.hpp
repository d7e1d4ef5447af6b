// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The cycles of a chain, in its own thread.
#ifndef OROFORGE_CHAIN_CYCLES_HPP
#define OROFORGE_CHAIN_CYCLES_HPP

#include "roster.hpp"

#include <rtt/OutputPort.hpp>

#include <atomic>
#include <cstdint>
#include <string>

namespace OCL::chain {

/** Executes the members. Only for the thread of the chain, except where it says otherwise; real-time safe. */
class Cycles {
public:
    explicit Cycles(std::string name) : name_(std::move(name)) {}

    /** The last part of a start: the next cycle is number 0. No cycle may be in progress. Not real-time safe. */
    void begin(const ChainStatistics& sample);

    /** One cycle; `period` in s, 0 for none. False if the chain has to go into RunTimeError. */
    bool execute(double period);
    /** Executes the messages of the members, but no cycle. */
    void serve();

    /** A failure or an overrun has not been logged yet, and the last log is long enough ago. */
    bool hasNews() const { return news_ && lastBegin_ - lastNews_ >= kBetweenNews; }
    void toldNews() {
        news_ = false;
        lastNews_ = lastBegin_;
    }
    /** Cycles since the start. Any thread. */
    unsigned iteration() const { return iteration_(); }

    RosterExchange rosters;  // publish(): any thread
    RTT::OutputPort<std::string> overrun{"overrun"};
    RTT::OutputPort<unsigned> count{"iteration"};
    RTT::OutputPort<ChainStatistics> statistics{"statistics"};

private:
    static constexpr std::int64_t kBetweenNews = 1000000000;
    /** How the turns of this cycle go on. */
    struct Course {
        std::int64_t now;  // the end of the last turn
        bool cut = false;  // members that follow only execute messages
        bool error = false;
    };

    Roster* take();
    void noteBegin(Roster& roster, double period);
    void turn(Member& member, const Settings& settings, Course& course);
    void run(Member& member, const RTT::internal::EngineGate::Visit& visit, const Settings& settings, Course& course);
    void fail(Member& member, bool threw, OnError onError, Course& course);
    void report(const Roster& roster, double period);

    const std::string name_;
    ChainStatistics sample_;  // of the port, with its final size
    Shown<unsigned> iteration_;
    const Roster* counted_ = nullptr;  // whose countdowns are up to date
    unsigned untilReport_ = 0;
    std::int64_t lastBegin_ = 0, lastNews_ = 0, lastTick_ = -1;
    bool news_ = false;
};

}  // namespace OCL::chain

#endif
