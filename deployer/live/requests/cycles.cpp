// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "cycles.hpp"

#include <rtt/internal/engine/hook_in_progress.hpp>
#include <rtt/os/fosi.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <mutex>

namespace OCL::live {
namespace {

using RTT::base::TaskCore;
using RTT::internal::HookInProgress;
using RTT::internal::HookWatch;

typedef std::atomic<std::int64_t> Number;

/** Of one component. Its thread writes the numbers, others read them. */
struct Entry {
    std::atomic<const TaskCore*> task{nullptr};
    Number period{0}, begin{0}, count{0}, duration{0}, longest{0}, latest{0}, overruns{0};

    void reset(const TaskCore* of, std::int64_t periodOf) {
        for (Number* const each : {&begin, &count, &duration, &longest, &latest, &overruns}) each->store(0);
        period = periodOf;
        task.store(of, std::memory_order_release);
    }
    Cycles now() const { return {count, duration, longest, latest, overruns}; }
};

struct Table {
    std::mutex mutex;  // guards what is not atomic, and changes of `size`
    unsigned users = 0;
    std::atomic<std::size_t> size{0};
    std::array<Entry, 256> entries;
};

/** Never destroyed: a hook may be executed when the process ends. */
Table& table() {
    static auto* const made = new Table();
    return *made;
}

// Hooks must not take the lock of a local static.
Table& shared = table();

Entry* entryOf(const TaskCore* task) {
    const std::size_t size = shared.size.load(std::memory_order_acquire);
    for (std::size_t i = 0; i != size; ++i)
        if (shared.entries[i].task.load(std::memory_order_relaxed) == task) return &shared.entries[i];
    return nullptr;
}

void raise(Number& number, std::int64_t to) {
    if (to > number.load(std::memory_order_relaxed)) number.store(to, std::memory_order_relaxed);
}

void add(Number& number, std::int64_t more) {
    number.store(number.load(std::memory_order_relaxed) + more, std::memory_order_relaxed);
}

bool isCycle(const HookInProgress& hook) { return hook.task && std::strcmp(hook.hook, "updateHook()") == 0; }

void onBegin(const HookInProgress& hook) {
    Entry* const entry = isCycle(hook) ? entryOf(hook.task) : nullptr;
    if (!entry) return;
    const std::int64_t now = rtos_get_time_ns(), before = entry->begin.exchange(now, std::memory_order_relaxed),
                       period = entry->period.load(std::memory_order_relaxed);
    if (before == 0 || period == 0) return;
    const std::int64_t late = now - before - period;
    raise(entry->latest, late);
    if (late >= period) add(entry->overruns, 1);
}

void onEnd(const HookInProgress& hook) {
    Entry* const entry = isCycle(hook) ? entryOf(hook.task) : nullptr;
    const std::int64_t begin = entry ? entry->begin.load(std::memory_order_relaxed) : 0;
    if (begin == 0) return;  // it began before the measurement
    const std::int64_t took = rtos_get_time_ns() - begin;
    add(entry->count, 1);
    add(entry->duration, took);
    raise(entry->longest, took);
}

const HookWatch kWatch = {&onBegin, &onEnd};

}  // namespace

Measurement::Measurement(const std::vector<std::pair<const TaskCore*, std::int64_t>>& components) {
    const std::lock_guard<std::mutex> lock(shared.mutex);
    if (shared.users == 0) {
        shared.size = 0;
        works_ = HookInProgress::replaceWatch(nullptr, &kWatch);
    } else {
        works_ = true;
    }
    if (!works_) return;
    ++shared.users;
    for (const auto& [task, period] : components) {
        Entry* entry = entryOf(task);
        const std::size_t size = shared.size;
        if (!entry && size != shared.entries.size()) {
            entry = &shared.entries[size];
            entry->reset(task, period);
            shared.size.store(size + 1, std::memory_order_release);
        }
        if (entry) before_.emplace_back(task, entry->now());
    }
}

Measurement::~Measurement() {
    if (!works_) return;
    const std::lock_guard<std::mutex> lock(shared.mutex);
    if (--shared.users == 0) (void)HookInProgress::replaceWatch(&kWatch, nullptr);
}

Cycles Measurement::of(const TaskCore* component) const {
    const auto before =
        std::find_if(before_.begin(), before_.end(), [&](const auto& each) { return each.first == component; });
    const Entry* const entry = before == before_.end() ? nullptr : entryOf(component);
    if (!entry) return {};
    Cycles made = entry->now();
    made.count -= before->second.count;
    made.duration -= before->second.duration;
    made.overruns -= before->second.overruns;
    return made;
}

}  // namespace OCL::live
