// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How a chain begins and ends, with its members if it manages them.
#include "impl.hpp"

#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/engine/topology.hpp>

#include <algorithm>

namespace OCL::chain {

using RTT::endlog;
using RTT::log;
typedef std::lock_guard<std::mutex> Lock;

std::vector<std::string> Impl::begin() {
    (void)RTT::internal::GlobalEngine::Instance();  // makes its thread, which a cycle must not do
    std::vector<std::string> findings;
    addTriggers(findings);
    const Lock lock(mutex);
    topology = RTT::internal::Topology::changes();
    Settings wanted;
    const Order order = present(wanted, findings);
    if (!findings.empty()) return findings;
    settings = wanted;
    if (!order.ignored.empty()) {
        std::string names;
        for (const std::string& name : order.ignored) names += (names.empty() ? "'" : ", '") + name + "'";
        log(RTT::Info) << "chain '" << chain.getName() << "' does not execute its other peers " << names << endlog();
    }
    measured.clear();
    measuredCycles = std::make_shared<MeasuredCycles>();
    periods = std::make_shared<RecentPeriods>(periods->size());
    overrunsTold = 0;
    rows.clear();
    for (const Peer& peer : order.members) rows.emplace(peer.name, static_cast<int>(rows.size()));
    publish(order);
    cycles.begin(statisticsOf(*this));
    running = true;
    logOrder("executes");
    return findings;
}

void Impl::end() {
    const Lock lock(mutex);
    if (!running) return;
    running = false;
    for (const Member& member : members) release(member);
    tellFailures();
}

bool Impl::configureMembers() {
    std::vector<std::string> findings;
    Order order;
    {
        const Lock lock(mutex);
        Settings none;
        order = present(none, findings);
    }
    return std::all_of(order.members.begin(), order.members.end(), [this](const Peer& peer) {
        const bool done = withComponent(
            peer, [](RTT::TaskContext& component) { return component.isConfigured() || component.configure(); });
        if (!done)
            log(RTT::Error) << "chain '" << chain.getName() << "' could not configure its member '" << peer.name << "'"
                            << endlog();
        return done;
    });
}

bool Impl::startMembers() {
    std::vector<Member> all;
    {
        const Lock lock(mutex);
        all = members;
    }
    for (const Member& member : all) {
        const bool done = withComponent(
            member.peer, [](RTT::TaskContext& component) { return component.isRunning() || component.start(); });
        if (done) continue;
        log(RTT::Error) << "chain '" << chain.getName() << "' could not start its member '" << member.peer.name
                        << "', so it does not start" << endlog();
        return false;
    }
    return true;
}

void Impl::stopMembers() {
    std::vector<Member> all;
    {
        const Lock lock(mutex);
        all = members;
    }
    std::for_each(all.rbegin(), all.rend(), [this](const Member& member) {
        (void)withComponent(member.peer, [this](RTT::TaskContext& component) {
            if (!component.isRunning() || component.stop()) return true;
            log(RTT::Error) << "chain '" << chain.getName() << "' could not stop its member '" << component.getName()
                            << "'" << endlog();
            return false;
        });
    });
}

}  // namespace OCL::chain
