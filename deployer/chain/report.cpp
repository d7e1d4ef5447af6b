// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What users see of a chain: numbers, tables, texts.
#include "data_flow.hpp"
#include "impl.hpp"

#include <rtt/os/ThreadInterface.hpp>
#include <rtt/os/fosi.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace OCL::chain {
namespace {

void addTimes(std::ostream& out, const ChainTimes& times) {
    for (const double value : {times.last, times.min, times.mean, times.p999, times.max, times.deviation})
        out << std::setw(11) << value * 1e6;
}

std::string schedulerName(int scheduler) {
    return scheduler == ORO_SCHED_RT ? "ORO_SCHED_RT" : scheduler == ORO_SCHED_OTHER ? "ORO_SCHED_OTHER" : "scheduler";
}

std::string threadText(RTT::TaskContext& chain) {
    std::ostringstream text;
    RTT::base::ActivityInterface* const activity = chain.getActivity();
    RTT::os::ThreadInterface* const thread = activity ? activity->thread() : nullptr;
    if (thread)
        text << "thread '" << thread->getName() << "', " << schedulerName(thread->getScheduler()) << ", priority "
             << thread->getPriority();
    else
        text << "no thread";
    const double period = activity ? activity->getPeriod() : 0;
    if (period > 0)
        text << ", period " << period << " s";
    else
        text << ", not periodic";
    return text.str();
}

}  // namespace

ChainStatistics statisticsOf(const Impl& impl) {
    ChainStatistics result;
    result.iteration = impl.cycles.iteration();
    impl.measuredCycles->durations.read(result.cycle);
    impl.measuredCycles->jitter.read(result.jitter);
    const double period = impl.chain.getPeriod();
    result.utilisation = period > 0 ? result.cycle.mean / period : 0;
    result.overruns = impl.measuredCycles->overruns();
    for (const Member& member : impl.members) {
        ChainMember row;
        row.name = member.peer.name;
        member.measured->times.read(row.times);
        row.overruns = member.measured->overruns();
        row.failures = member.measured->failures();
        row.left_out = member.measured->leftOut();
        result.failures += row.failures;
        result.members.push_back(row);
    }
    return result;
}

std::string tableOf(const ChainStatistics& all, const RecentPeriods& periods) {
    std::size_t width = 8;
    for (const ChainMember& member : all.members) width = std::max(width, member.name.size());
    const auto name = static_cast<int>(width);
    std::ostringstream out;
    out << std::fixed << std::setprecision(1);
    out << std::left << std::setw(name) << "times/us" << std::right << std::setw(9) << "count" << std::setw(11)
        << "last" << std::setw(11) << "min" << std::setw(11) << "mean" << std::setw(11) << "99.9 %" << std::setw(11)
        << "max" << std::setw(11) << "deviation" << std::setw(9) << "overrun" << std::setw(8) << "failed"
        << std::setw(9) << "left out"
        << "\n";
    for (const ChainMember& member : all.members) {
        out << std::left << std::setw(name) << member.name << std::right << std::setw(9) << member.times.count;
        addTimes(out, member.times);
        out << std::setw(9) << member.overruns << std::setw(8) << member.failures << std::setw(9) << member.left_out
            << "\n";
    }
    out << std::left << std::setw(name) << "cycle" << std::right << std::setw(9) << all.cycle.count;
    addTimes(out, all.cycle);
    out << std::setw(9) << all.overruns << std::setw(8) << all.failures << "\n";
    if (all.jitter.count != 0) {
        out << std::left << std::setw(name) << "jitter" << std::right << std::setw(9) << all.jitter.count;
        addTimes(out, all.jitter);
        out << "\n"
            << "utilisation " << std::setprecision(2) << all.utilisation * 100 << " %\n";
    }
    const std::vector<std::int64_t> recent = periods.all();
    if (recent.empty()) return out.str();
    Times times;
    for (const std::int64_t period : recent) times.add(period);
    ChainTimes read;
    times.read(read);
    out << std::setprecision(1) << "last " << read.count << " periods/us: min " << read.min * 1e6 << ", mean "
        << read.mean * 1e6 << ", max " << read.max * 1e6 << ", deviation " << read.deviation * 1e6 << "\n";
    return out.str();
}

std::string descriptionOf(Impl& impl) {
    std::vector<std::string> findings;
    Settings wanted;
    const Order order = impl.present(wanted, findings);
    std::ostringstream text;
    text << "chain '" << impl.chain.getName() << "': " << threadText(impl.chain) << "\n";
    for (std::size_t i = 0; i != order.members.size(); ++i) {
        const std::string& name = order.members[i].name;
        text << "  " << i + 1 << " " << name;
        const auto divider = wanted.dividers.find(name);
        if (divider != wanted.dividers.end())
            text << ", in 1 of " << divider->second.every << " cycles, from " << divider->second.phase;
        const auto budget = wanted.budgets.find(name);
        if (budget != wanted.budgets.end()) text << ", budget " << static_cast<double>(budget->second) * 1e-9 << " s";
        text << "\n";
    }
    for (const Flow& flow : flowsOf(order.members))
        if (flow.isDelayed()) text << "  one cycle late: " << textOf(flow, order.members) << "\n";
    for (const std::string& finding : findings) text << "  error: " << finding << "\n";
    return text.str();
}

}  // namespace OCL::chain
