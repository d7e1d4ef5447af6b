// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The state of a chain that its header does not show.
#ifndef OROFORGE_CHAIN_IMPL_HPP
#define OROFORGE_CHAIN_IMPL_HPP

#include <ocl/Chain.hpp>

#include "cycles.hpp"
#include "housekeeper.hpp"

#include <rtt/internal/values/newer_properties.hpp>

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace OCL::chain {

struct Impl {
    Impl(Chain& owner, bool othersMayFollow);
    ~Impl();

    // triggers.cpp
    void addTriggers(std::vector<std::string>& findings);
    void onSamples(RTT::base::InputPortInterface& port);

    // lifecycle.cpp; guarded by the mutex, which they take
    /** Checks and publishes the first roster; the findings, none if the chain has begun. */
    std::vector<std::string> begin();
    void end();
    bool configureMembers();
    bool startMembers();
    void stopMembers();

    // maintain.cpp
    /** Adapts the roster to the present peers, if the chain runs. */
    void update();
    void housekeep();
    /** Forgets what was measured. */
    void forgetMeasured();

    // The following need the mutex.
    /** `findings` gets what is wrong with properties and peers. */
    Order present(Settings& wanted, std::vector<std::string>& findings) const;
    void publish(const Order& order);
    void addRows(Roster& roster);
    void release(const Member& member) const;
    void tellFailures();
    void logOrder(const char* what) const;

    /** One cycle in the thread of the chain; real-time safe. */
    void cycle();

    Chain& chain;
    /** Files for the function-block scheduler have none of these. */
    const RTT::internal::NewerProperties newer{*chain.properties(),
                                               {"on_error", "divider", "dividers", "budget", "budgets",
                                                "stop_on_overrun", "events", "triggers", "report_every", "manage"}};
    const bool othersFollow;
    Properties properties;
    Cycles cycles;
    Housekeeper* const housekeeper;

    mutable std::mutex mutex;
    // Guarded by the mutex.
    bool running = false;
    Settings settings;
    std::vector<Member> members;  // as in the last roster
    std::map<std::string, std::shared_ptr<Measured>> measured;
    std::shared_ptr<MeasuredCycles> measuredCycles = std::make_shared<MeasuredCycles>();
    std::shared_ptr<RecentPeriods> periods = std::make_shared<RecentPeriods>(3000);
    std::vector<std::string> rows;  // of the sample of the port `statistics`: all members since the start
    unsigned overrunsTold = 0;

    bool executing = false;                  // for the thread of the chain
    std::atomic<std::uint32_t> topology{0};  // the one for which the roster was made
    std::vector<std::unique_ptr<RTT::base::InputPortInterface>> ownPorts;
};

// report.cpp
ChainStatistics statisticsOf(const Impl& impl);
std::string tableOf(const ChainStatistics& statistics, const RecentPeriods& periods);
std::string descriptionOf(Impl& impl);

/** Calls `use(component)` if the peer is still there; false otherwise. */
template <class Use>
bool withComponent(const Peer& peer, Use&& use) {
    const RTT::internal::EngineGate::Visit visit(*peer.gate);
    auto* const component = dynamic_cast<RTT::TaskContext*>(componentOf(visit));
    return component && use(*component);
}

}  // namespace OCL::chain

#endif
