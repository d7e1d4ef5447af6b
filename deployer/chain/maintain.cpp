// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Keeps the roster of a running chain up to date, and logs failures, outside its thread.
#include "data_flow.hpp"
#include "impl.hpp"

#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/internal/engine/topology.hpp>

#include <algorithm>
#include <set>
#include <utility>

namespace OCL::chain {
namespace {

using RTT::endlog;
using RTT::log;
using RTT::extras::SlaveActivity;
using RTT::internal::EngineGate;
typedef std::lock_guard<std::mutex> Lock;

bool isSame(const std::vector<Member>& members, const std::vector<Peer>& peers) {
    return std::equal(members.begin(), members.end(), peers.begin(), peers.end(), [](const Member& a, const Peer& b) {
        return a.peer.gate == b.gate && a.peer.slave == b.slave && a.peer.name == b.name;
    });
}

void setInTurn(const Peer& peer, bool inTurn) {
    const EngineGate::Visit visit(*peer.gate);
    if (visit.engine() && visit.activity() == peer.slave) peer.slave->setInTurn(inTurn);
}

}  // namespace

Order Impl::present(Settings& wanted, std::vector<std::string>& findings) const {
    wanted = Settings::from(properties, findings);
    Order order = orderOf(chain.getName(), peersOf(chain), chain.sched_order, othersFollow);
    findings.insert(findings.end(), order.findings.begin(), order.findings.end());
    std::set<std::string> names;
    for (const Peer& peer : order.members) names.insert(peer.name);
    const auto checkNames = [&](const auto& values, const char* what) {
        for (const auto& value : values)
            if (!names.count(value.first))
                findings.push_back(std::string(what) + " names '" + value.first + "', which is no member of '" +
                                   chain.getName() + "'; correct the name or leave it out");
    };
    checkNames(wanted.dividers, "a divider");
    checkNames(wanted.budgets, "a budget");
    return order;
}

void Impl::publish(const Order& order) {
    auto roster = std::make_unique<Roster>();
    roster->settings = settings;
    roster->cycles = measuredCycles;
    roster->periods = periods;
    std::set<std::pair<const EngineGate*, const SlaveActivity*>> kept;
    for (const Peer& peer : order.members) {
        Member member;
        member.peer = peer;
        const auto divider = settings.dividers.find(peer.name);
        if (divider != settings.dividers.end()) member.divider = divider->second;
        const auto budget = settings.budgets.find(peer.name);
        if (budget != settings.budgets.end()) member.budget = budget->second;
        std::shared_ptr<Measured>& known = measured[peer.name];  // also of one that was there before
        if (!known) known = std::make_shared<Measured>();
        member.measured = known;
        const auto row = rows.find(peer.name);
        if (row != rows.end()) member.row = row->second;
        roster->members.push_back(member);
        kept.emplace(peer.gate.get(), peer.slave);
        setInTurn(peer, settings.inOrder);
    }
    for (const Member& member : members)
        if (!kept.count({member.peer.gate.get(), member.peer.slave})) release(member);
    members = roster->members;
    cycles.rosters.publish(std::move(roster));
}

void Impl::release(const Member& member) const { setInTurn(member.peer, false); }

void Impl::update() {
    const Lock lock(mutex);
    if (!running) return;
    const std::uint32_t now = RTT::internal::Topology::changes();
    const Order order = orderOf(chain.getName(), peersOf(chain), chain.sched_order, othersFollow);
    topology = now;
    if (isSame(members, order.members)) return;
    publish(order);
    logOrder("now executes");
}

void Impl::housekeep() {
    if (RTT::internal::Topology::changes() != topology) update();
    const Lock lock(mutex);
    if (running) tellFailures();
}

void Impl::forgetMeasured() {
    const Lock lock(mutex);
    measured.clear();
    measuredCycles = std::make_shared<MeasuredCycles>();
    periods = std::make_shared<RecentPeriods>(periods->size());
    overrunsTold = 0;
    Order same;
    for (const Member& member : members) same.members.push_back(member.peer);
    if (running) publish(same);
    if (running) return;
    for (Member& member : members) member.measured = measured[member.peer.name] = std::make_shared<Measured>();
}

void Impl::tellFailures() {
    for (const auto& [name, one] : measured) {
        const unsigned failures = one->failures();
        const unsigned more = failures - std::exchange(one->told, failures);
        if (more == 0) continue;
        log(RTT::Error) << "chain '" << chain.getName() << "': member '" << name << "' failed in " << more
                        << (more == 1 ? " cycle: " : " cycles: ")
                        << (one->threw() ? "its code threw, so it is in Exception; recover() ends that"
                                         : "its activity is not active, or another thread is executing it")
                        << endlog();
    }
    const unsigned overruns = measuredCycles->overruns();
    const unsigned more = overruns - std::exchange(overrunsTold, overruns);
    if (more != 0)
        log(RTT::Warning) << "chain '" << chain.getName() << "': " << more
                          << (more == 1 ? " cycle took" : " cycles took") << " longer than the budget of "
                          << static_cast<double>(settings.budget) * 1e-9 << " s" << endlog();
}

void Impl::logOrder(const char* what) const {
    std::string names;
    for (const Member& member : members) names += (names.empty() ? "" : ", ") + member.peer.name;
    log(RTT::Info) << "chain '" << chain.getName() << "' " << what << ": " << (names.empty() ? "nothing" : names)
                   << endlog();
    std::vector<Peer> peers;
    for (const Member& member : members) peers.push_back(member.peer);
    for (const Flow& flow : flowsOf(peers))
        if (flow.isDelayed())
            log(RTT::Info) << "chain '" << chain.getName() << "': values of " << textOf(flow, peers)
                           << " are read one cycle later, because of the order" << endlog();
}

}  // namespace OCL::chain
