// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/os/StartStopManager.hpp>

#include <algorithm>
#include <mutex>
#include <vector>

namespace RTT::os {

namespace {

template <class Function>
struct Registered {
    Function function;
    int phase;
};

/** Keeps the functions sorted by phase, those of one phase in the order of registration. */
template <class Function>
void insert(std::vector<Registered<Function>>& into, Function function, int phase) {
    const auto behind = std::upper_bound(into.begin(), into.end(), phase,
                                         [](int p, const Registered<Function>& r) { return p < r.phase; });
    into.insert(behind, Registered<Function>{function, phase});
}

template <class Function>
void erase(std::vector<Registered<Function>>& from, Function function) {
    const auto at =
        std::find_if(from.begin(), from.end(), [=](const Registered<Function>& r) { return r.function == function; });
    if (at != from.end()) from.erase(at);
}

}  // namespace

struct StartStopManager::Registry {
    std::mutex mutex;  // never held while a registered function runs
    std::vector<Registered<start_fun>> starts;
    std::vector<Registered<stop_fun>> stops;
    bool started = false;
};

StartStopManager::StartStopManager() : registry_(new Registry) {}

StartStopManager* StartStopManager::Instance() {
    // Never destroyed: static CleanupFunction objects of libraries unregister when the process ends.
    static StartStopManager* const instance = new StartStopManager;
    return instance;
}

void StartStopManager::startFunction(start_fun function, int phase) {
    bool late = false;
    {
        std::lock_guard<std::mutex> lock(registry_->mutex);
        insert(registry_->starts, function, phase);
        late = registry_->started;
    }
    if (late) function();
}

void StartStopManager::stopFunction(stop_fun function, int phase) {
    std::lock_guard<std::mutex> lock(registry_->mutex);
    insert(registry_->stops, function, phase);
}

void StartStopManager::removeStartFunction(start_fun function) {
    std::lock_guard<std::mutex> lock(registry_->mutex);
    erase(registry_->starts, function);
}

void StartStopManager::removeStopFunction(stop_fun function) {
    std::lock_guard<std::mutex> lock(registry_->mutex);
    erase(registry_->stops, function);
}

int StartStopManager::start() {
    std::vector<Registered<start_fun>> now;
    {
        std::lock_guard<std::mutex> lock(registry_->mutex);
        if (registry_->started) return 0;
        registry_->started = true;
        now = registry_->starts;
    }
    for (const auto& entry : now)
        if (const int result = entry.function()) return result;
    return 0;
}

void StartStopManager::stop() {
    std::vector<Registered<stop_fun>> now;
    {
        std::lock_guard<std::mutex> lock(registry_->mutex);
        if (!registry_->started) return;
        registry_->started = false;
        now = registry_->stops;
    }
    // Phases go forwards, functions of a phase backwards: what was registered last may use what existed before.
    for (auto first = now.begin(); first != now.end();) {
        auto last = first;
        while (last != now.end() && last->phase == first->phase) ++last;
        for (auto at = last; at != first;) (--at)->function();
        first = last;
    }
}

InitFunction::InitFunction(start_fun function, int phase) : function_(function) {
    StartStopManager::Instance()->startFunction(function, phase);
}
InitFunction::~InitFunction() { StartStopManager::Instance()->removeStartFunction(function_); }

CleanupFunction::CleanupFunction(stop_fun function, int phase) : function_(function) {
    StartStopManager::Instance()->stopFunction(function, phase);
}
CleanupFunction::~CleanupFunction() { StartStopManager::Instance()->removeStopFunction(function_); }

}  // namespace RTT::os
