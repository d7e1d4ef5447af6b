// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "peers.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/ExecutionEngine.hpp>
#include <rtt/extras/SlaveActivity.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace OCL::chain {
namespace {

using RTT::extras::SlaveActivity;
using RTT::internal::EngineGate;

constexpr const char* kOthers = "*";

std::string quoted(const std::string& name) { return "'" + name + "'"; }

std::string hint(const std::string& chain, const std::string& member) {
    return "setMasterSlaveActivity(\"" + chain + "\", \"" + member + "\") is missing";
}

/** Why a peer cannot be a member; empty if it can. */
std::string obstacle(const std::string& chain, const Peer& peer) {
    switch (peer.relation) {
        case Peer::Slave:
        case Peer::Masterless: return {};
        case Peer::OfOther:
            return quoted(peer.name) + " is a slave of " +
                   (peer.master.empty() ? "a component that is gone" : quoted(peer.master)) + ", not of " +
                   quoted(chain) + "; " + hint(chain, peer.name);
        case Peer::OwnThread: return quoted(peer.name) + " is no slave; " + hint(chain, peer.name);
        case Peer::Self: return quoted(peer.name) + " is the chain itself; take it out of sched_order";
        case Peer::Master:
            return quoted(peer.name) + " executes the chain " + quoted(chain) +
                   ", so it cannot be a member; take it out of sched_order";
    }
    return {};
}

class Ordering {
public:
    Ordering(const std::string& chain, const std::vector<Peer>& peers) : chain_(chain), peers_(peers) {
        for (const Peer& peer : peers) byName_[peer.name] = &peer;
    }

    Order make(std::vector<std::string> wished, bool othersFollow) {
        const bool hasOthers = std::count(wished.begin(), wished.end(), kOthers) != 0;
        if (wished.empty() || (othersFollow && !hasOthers)) wished.push_back(kOthers);
        for (const std::string& name : wished)
            if (byName_.count(name)) named_.insert(byName_.at(name)->gate.get());
        for (const std::string& name : wished) name == kOthers ? addOthers() : addNamed(name);
        for (const Peer& peer : peers_)
            if (!taken_.count(peer.gate.get())) order_.ignored.push_back(peer.name);
        if (order_.members.empty() && order_.findings.empty())
            order_.findings.push_back("there is no peer that is a slave of " + quoted(chain_) + "; " +
                                      hint(chain_, "…"));
        return std::move(order_);
    }

private:
    void addNamed(const std::string& name) {
        const auto found = byName_.find(name);
        if (found == byName_.end()) {
            std::vector<std::string> known;
            for (const Peer& peer : peers_) known.push_back(peer.name);
            const std::string likely = oroforge::diag::didYouMean(name, known);
            order_.findings.push_back(quoted(name) + " of sched_order is no peer of " + quoted(chain_) +
                                      (likely.empty() ? "; " + hint(chain_, name) : likely));
            return;
        }
        const std::string why = obstacle(chain_, *found->second);
        if (!why.empty())
            order_.findings.push_back(why);
        else if (!taken_.insert(found->second->gate.get()).second)
            order_.findings.push_back(quoted(name) + " is twice in sched_order; leave one out");
        else
            order_.members.push_back(*found->second);
    }

    void addOthers() {
        if (hasOthers_) return order_.findings.push_back("'*' is twice in sched_order; leave one out");
        hasOthers_ = true;
        for (const Peer& peer : peers_)
            if (peer.relation == Peer::Slave && !named_.count(peer.gate.get()) && taken_.insert(peer.gate.get()).second)
                order_.members.push_back(peer);
    }

    const std::string& chain_;
    const std::vector<Peer>& peers_;
    std::map<std::string, const Peer*> byName_;
    std::set<const EngineGate*> named_, taken_;
    bool hasOthers_ = false;
    Order order_;
};

Peer::Relation relationOf(const SlaveActivity& slave, RTT::base::ActivityInterface* chain) {
    if (!slave.hasMaster()) return Peer::Masterless;
    return chain && slave.isSlaveOf(*chain) ? Peer::Slave : Peer::OfOther;
}

}  // namespace

RTT::base::TaskCore* componentOf(const EngineGate::Visit& visit) {
    const RTT::ExecutionEngine* const engine = visit.engine();
    return engine ? engine->getTaskCore() : nullptr;
}

std::vector<Peer> peersOf(RTT::TaskContext& chain) {
    RTT::base::ActivityInterface* const own = chain.getActivity();
    const auto* const ownAsSlave = dynamic_cast<const SlaveActivity*>(own);
    const std::string master = ownAsSlave ? ownAsSlave->masterName() : std::string();
    std::vector<Peer> peers;
    for (const auto& [name, gate] : chain.getPeerGates()) {
        Peer peer;
        peer.name = name;
        peer.gate = gate;
        const EngineGate::Visit visit(*gate);
        const RTT::base::TaskCore* const component = componentOf(visit);
        if (!component) continue;
        peer.slave = dynamic_cast<SlaveActivity*>(visit.activity());
        if (peer.slave) peer.relation = relationOf(*peer.slave, own);
        if (peer.relation == Peer::OfOther) peer.master = peer.slave->masterName();
        if (gate == chain.engine()->gate())
            peer.relation = Peer::Self;
        else if (!master.empty() && component->getName() == master)
            peer.relation = Peer::Master;
        peers.push_back(peer);
    }
    return peers;
}

Order orderOf(const std::string& chain, const std::vector<Peer>& peers, const std::vector<std::string>& wished,
              bool othersFollow) {
    return Ordering(chain, peers).make(wished, othersFollow);
}

}  // namespace OCL::chain
