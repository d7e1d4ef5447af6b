// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/Chain.hpp>

#include "data_flow.hpp"
#include "impl.hpp"
#include "types.hpp"

#include <fbsched/fbsched.hpp>

#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>
#include <rtt/internal/engine/topology.hpp>

#include <iostream>

namespace OCL {

using RTT::endlog;
using RTT::log;
typedef std::lock_guard<std::mutex> Lock;

namespace {

// Samples that come during a cycle count, too.
const int kQueuedTriggers = 64;

std::string joined(const std::vector<std::string>& lines, const char* before) {
    std::string text;
    for (const std::string& line : lines) text += before + line + "\n";
    return text;
}

void addProperties(Chain& chain, std::vector<std::string>& order, chain::Properties& values) {
    chain.addProperty("sched_order", order)
        .doc("Names of members in their order. \"*\" stands for all other slaves; empty: all slaves.");
    chain.addProperty("on_error", values.on_error)
        .doc("If a member fails: skip, the others go on; stop_cycle, until the next cycle; stop, in RunTimeError.");
    chain.addProperty("divider", values.divider)
        .doc("For each named member: the number of cycles of which it runs in one, as 2, or with a phase, as \"2+1\".");
    chain.addProperty("dividers", values.dividers).doc("The same as texts, such as \"a:2\" or \"a:2+1\".");
    chain.addProperty("budget", values.budget).doc("How long a cycle may take; 0: as long as it wants. [s]");
    chain.addProperty("budgets", values.budgets).doc("For each named member: how long its turn may take. [s]");
    chain.addProperty("stop_on_overrun", values.stop_on_overrun)
        .doc("Does a cycle or member that takes too long put this into RunTimeError?");
    chain.addProperty("events", values.events)
        .doc("Messages and callbacks of members are executed in_order: in their turn; or at_once: between cycles.");
    chain.addProperty("triggers", values.triggers)
        .doc("Further ports of which each sample is one cycle; \"name:type\" makes one in configure() or start().");
    chain.addProperty("report_every", values.report_every)
        .doc("Number of cycles from one sample on the port statistics to the next; 0: none.");
    chain.addProperty("manage", values.manage).doc("Are the members configured, started and stopped with this?");
}

}  // namespace

namespace chain {

Impl::Impl(Chain& owner, bool othersMayFollow)
    : chain(owner),
      othersFollow(othersMayFollow),
      cycles(owner.getName()),
      housekeeper(new Housekeeper([](void* self) { static_cast<Impl*>(self)->housekeep(); }, this)) {
    addProperties(owner, owner.sched_order, properties);
}

Impl::~Impl() { housekeeper->dismiss(); }

void Impl::cycle() {
    // Not within a cycle of this thread, and not after an error.
    if (executing || chain.RTT::base::TaskCore::getTaskState() != RTT::base::TaskCore::Running) return;
    executing = true;
    if (!cycles.execute(chain.RTT::base::TaskCore::getPeriod())) chain.error();
    executing = false;
    const bool news = cycles.hasNews();
    if (news) cycles.toldNews();
    if (news || RTT::internal::Topology::changes() != topology) housekeeper->request();
}

}  // namespace chain

Chain::Chain(const std::string& name) : Chain(name, false) {}

Chain::Chain(const std::string& name, bool othersFollow)
    : RTT::TaskContext(name, Stopped),
      trigger_port("trigger", RTT::ConnPolicy::buffer(kQueuedTriggers)),
      clock_port("inClock", RTT::ConnPolicy::buffer(kQueuedTriggers)),
      impl_((chain::addTypes(), new chain::Impl(*this, othersFollow))) {
    mTriggerOnStart = false;  // one cycle per sample, and none before the first
    addEventPort(trigger_port, [this](RTT::base::PortInterface*) {
        impl_->onSamples(trigger_port);
    }).doc("Each sample is one cycle, whatever its value.");
    addEventPort(clock_port, [this](RTT::base::PortInterface*) {
        impl_->onSamples(clock_port);
    }).doc("The same as trigger, for old configurations.");
    addPort(impl_->cycles.overrun).doc("The name of a member whose turn took too long, or of this if a cycle did.");
    addPort(impl_->cycles.count).doc("The number of the cycle that has ended, from 0.");
    addPort(impl_->cycles.statistics).doc("What was measured since start(), every report_every cycles.");

    addOperation("displaySchedList", &Chain::displaySchedList, this).doc("Writes the order to standard output.");
    addOperation("order", &Chain::order, this).doc("The members in their order.");
    addOperation("stats", &Chain::stats, this).doc("What was measured since start().");
    addOperation("resetStats", &Chain::resetStats, this).doc("Forgets what was measured.");
    addOperation("timeReport", &Chain::timeReport, this).doc("What was measured, as a table.");
    addOperation("setMaxBufferSize", &Chain::setMaxBufferSize, this)
        .doc("Sets how many of the last periods timeReport() looks at.")
        .arg("periods", "from 1 to 1000000");
    addOperation("step", &Chain::step, this, RTT::OwnThread)
        .doc("Executes one cycle. False if this does not run or is periodic.");
    addOperation("check", &Chain::check, this).doc("What is wrong with the configuration; empty: nothing.");
    addOperation("describe", &Chain::describe, this).doc("Order, thread, and data that are read a cycle later.");
    addOperation("dot", &Chain::dot, this).doc("Order and connections of the members, for Graphviz.");
}

Chain::~Chain() { stopForGood(); }

bool Chain::addPeer(RTT::TaskContext* peer, std::string alias) {
    const bool added = RTT::TaskContext::addPeer(peer, alias);
    if (added) impl_->update();
    return added;
}

void Chain::removePeer(const std::string& name) {
    RTT::TaskContext::removePeer(name);
    impl_->update();
}

void Chain::removePeer(RTT::TaskContext* peer) {
    RTT::TaskContext::removePeer(peer);
    impl_->update();
}

void Chain::displaySchedList() {
    std::string text = "Order of " + getName() + ":\n" + joined(order(), "  ");
    std::cout << text << std::flush;
}

std::vector<std::string> Chain::order() {
    const Lock lock(impl_->mutex);
    std::vector<std::string> names;
    if (impl_->running) {
        for (const chain::Member& member : impl_->members) names.push_back(member.peer.name);
        return names;
    }
    std::vector<std::string> findings;
    chain::Settings wanted;
    for (const chain::Peer& peer : impl_->present(wanted, findings).members) names.push_back(peer.name);
    return names;
}

ChainStatistics Chain::stats() {
    const Lock lock(impl_->mutex);
    return chain::statisticsOf(*impl_);
}

void Chain::resetStats() { impl_->forgetMeasured(); }

std::string Chain::timeReport() {
    std::string text;
    std::vector<chain::Member> members;
    {
        const Lock lock(impl_->mutex);
        text = "chain '" + getName() + "', " + std::to_string(impl_->cycles.iteration()) + " cycles\n" +
               chain::tableOf(chain::statisticsOf(*impl_), *impl_->periods);
        members = impl_->members;
    }
    for (const chain::Member& member : members)
        (void)chain::withComponent(member.peer, [&](RTT::TaskContext& component) {
            auto* const inner = dynamic_cast<Chain*>(&component);
            if (inner) text += "\n" + inner->timeReport();
            return inner != nullptr;
        });
    return text;
}

bool Chain::setMaxBufferSize(int periods) {
    if (periods < 1 || periods > 1000000) {
        log(RTT::Error) << "chain '" << getName() << "' cannot keep " << periods
                        << " periods; setMaxBufferSize() takes a number from 1 to 1000000" << endlog();
        return false;
    }
    {
        const Lock lock(impl_->mutex);
        impl_->periods = std::make_shared<chain::RecentPeriods>(static_cast<std::size_t>(periods));
    }
    impl_->forgetMeasured();
    return true;
}

std::string Chain::check() {
    const Lock lock(impl_->mutex);
    std::vector<std::string> findings;
    chain::Settings wanted;
    (void)impl_->present(wanted, findings);
    return joined(findings, "");
}

std::string Chain::describe() {
    const Lock lock(impl_->mutex);
    return chain::descriptionOf(*impl_);
}

std::string Chain::dot() {
    const Lock lock(impl_->mutex);
    std::vector<std::string> findings;
    chain::Settings wanted;
    return chain::dotOf(getName(), impl_->present(wanted, findings).members);
}

bool Chain::step() {
    if (impl_->executing || RTT::base::TaskCore::getTaskState() != Running || RTT::base::TaskCore::getPeriod() > 0)
        return false;
    impl_->cycle();
    return true;
}

bool Chain::configureHook() {
    std::vector<std::string> findings;
    impl_->addTriggers(findings);
    for (const std::string& finding : findings)
        log(RTT::Error) << "chain '" << getName() << "' cannot be configured: " << finding << endlog();
    if (!findings.empty()) return false;
    return !impl_->properties.manage || impl_->configureMembers();
}

bool Chain::startHook() {
    if (impl_->properties.manage && !impl_->configureMembers()) return false;
    const std::vector<std::string> findings = impl_->begin();
    if (!findings.empty()) {
        log(RTT::Error) << "chain '" << getName() << "' cannot start:\n" << joined(findings, "  ") << endlog();
        return false;
    }
    if (!impl_->properties.manage || impl_->startMembers()) return true;
    stopHook();
    return false;
}

void Chain::updateHook() { impl_->cycle(); }

void Chain::errorHook() { impl_->cycles.serve(); }

void Chain::stopHook() {
    impl_->end();
    if (impl_->properties.manage) impl_->stopMembers();
}

void Chain::cleanupHook() {
    const Lock lock(impl_->mutex);
    impl_->members.clear();
}

}  // namespace OCL

FBSched::FBSched(const std::string& name) : OCL::Chain(name, true) {}

FBSched::~FBSched() { stopForGood(); }
