// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The verb `top`.
#include "cycles.hpp"
#include "fields.hpp"
#include "interface_json.hpp"
#include "ticket.hpp"
#include "verbs.hpp"

#include <rtt/ExecutionEngine.hpp>
#include <rtt/base/ActivityInterface.hpp>
#include <rtt/internal/engine/deferred_activity.hpp>
#include <rtt/os/fosi.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>
#include <utility>

namespace OCL::live {
namespace {

using nlohmann::json;

constexpr double kLongest = 10;
/** So often it looks whether somebody still wants the answer, in ns. */
constexpr std::int64_t kLook = 100000000;

struct Row {
    json made;
    const RTT::base::TaskCore* task;  // only compared
    double period = 0;
    unsigned tid = 0;
    std::int64_t ran = 0;  // ns on a processor before
};

/** The time that a thread has spent on a processor, in ns; −1 if the kernel does not say. */
std::int64_t timeOf(unsigned tid) {
    std::ifstream file("/proc/self/task/" + std::to_string(tid) + "/schedstat");
    std::int64_t time = -1;
    return tid != 0 && file >> time ? time : -1;
}

Row rowOf(const std::string& name, RTT::TaskContext& component) {
    Row row{{{"name", name}, {"state", stateOf(component)}}, &component};
    json& made = row.made;
    for (const char* const each : {"thread", "tid", "priority", "scheduler", "cpus", "cpu"}) made[each] = nullptr;
    RTT::base::ActivityInterface* activity = component.engine()->getActivity();
    // A question must not make the thread of a component that has not needed it yet.
    if (auto* const deferred = dynamic_cast<RTT::internal::DeferredActivity*>(activity)) activity = deferred->ifMade();
    if (activity) row.period = activity->getPeriod();
    made["period"] = row.period;
    // One that has not begun may have no thread yet.
    RTT::os::ThreadInterface* const thread = activity && activity->isActive() ? activity->thread() : nullptr;
    if (!thread) return row;
    row.tid = thread->getPid();
    made["thread"] = thread->getName();
    made["tid"] = row.tid;
    made["priority"] = thread->getPriority();
    made["scheduler"] = thread->getScheduler() == ORO_SCHED_RT ? "ORO_SCHED_RT" : "ORO_SCHED_OTHER";
    made["cpus"] = thread->getCpuAffinity();
    return row;
}

std::vector<Row> rowsOf(const Root& root) {
    std::vector<Row> rows;
    Visits visits;
    const KnownPorts known({root.gate}, visits);
    for (const auto& [name, component] : known.components()) rows.push_back(rowOf(name, *component));
    return rows;
}

double inSeconds(std::int64_t ns) { return static_cast<double>(ns) * 1e-9; }

void addTimes(Row& row, const Measurement& measurement, double seconds) {
    const std::int64_t ran = timeOf(row.tid);
    if (ran >= 0 && row.ran >= 0) row.made["cpu"] = std::max(0.0, inSeconds(ran - row.ran) / seconds);
    for (const char* const each : {"cycles", "duration", "longest", "lateness", "overruns"}) row.made[each] = nullptr;
    if (!measurement.works()) return;
    const Cycles cycles = measurement.of(row.task);
    row.made["cycles"] = cycles.count;
    if (cycles.count == 0) return;
    row.made["duration"] = inSeconds(cycles.duration / cycles.count);
    row.made["longest"] = inSeconds(cycles.longest);
    if (row.period == 0) return;
    row.made["lateness"] = inSeconds(cycles.latest);
    row.made["overruns"] = cycles.overruns;
}

}  // namespace

json top(const Asked& asked) {
    const double seconds = std::min(secondsField(asked.request, "seconds", 0.5), kLongest);
    std::vector<Row> rows = rowsOf(asked.root);
    std::vector<std::pair<const RTT::base::TaskCore*, std::int64_t>> measured;
    for (const Row& row : rows) measured.emplace_back(row.task, static_cast<std::int64_t>(row.period * 1e9));
    const Measurement measurement(measured);
    for (Row& row : rows) row.ran = timeOf(row.tid);
    const std::int64_t begin = rtos_get_time_ns();
    const std::int64_t end = begin + static_cast<std::int64_t>(seconds * 1e9);
    for (std::int64_t now = begin; now < end && !WorkFor::isOver(); now = rtos_get_time_ns())
        std::this_thread::sleep_for(std::chrono::nanoseconds(std::min(end - now, kLook)));
    const double passed = inSeconds(rtos_get_time_ns() - begin);
    json components = json::array();
    for (Row& row : rows) {
        addTimes(row, measurement, passed);
        components.push_back(std::move(row.made));
    }
    return {{"seconds", passed}, {"components", std::move(components)}};
}

}  // namespace OCL::live
