// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/machine/machine_status.hpp>

namespace RTT::scripting::detail {

MachineObserver::~MachineObserver() = default;

MachineStatus::Value MachineStatus::value() const {
    const Value now = status_.load(std::memory_order_acquire);
    const bool stops = requests_.load(std::memory_order_relaxed) & kStop;
    return stops && now != Status::inactive && now != Status::deactivating ? Status::stopping : now;
}

bool MachineStatus::pause() {
    const Value now = value();
    if (now == Status::inactive || now == Status::deactivating) return false;
    requests_.fetch_or(kPause, std::memory_order_release);
    return true;
}

bool MachineStatus::step() {
    // A step may follow a pause that has not taken effect.
    unsigned requests = requests_.load(std::memory_order_relaxed);
    while ((requests & kPause) && !(requests & kStop)) {
        if (requests & kStep) return false;
        if (requests_.compare_exchange_weak(requests, requests | kStep, std::memory_order_release,
                                            std::memory_order_relaxed))
            return true;
    }
    const Value now = value();
    if (now == Status::paused) return !(requests_.fetch_or(kStep, std::memory_order_release) & kStep);
    Value expected = Status::active;
    return now == Status::active && status_.compare_exchange_strong(expected, Status::requesting);
}

bool MachineStatus::stop() {
    const Value now = value();
    if (now == Status::inactive || now == Status::deactivating) return false;
    if (now == Status::stopped)
        requests_.fetch_and(kStop, std::memory_order_relaxed);
    else
        requests_.store(kStop, std::memory_order_release);
    return true;
}

unsigned MachineStatus::takeRequests() {
    unsigned requests = requests_.load(std::memory_order_relaxed), later;
    do {
        const bool stops = (requests & kStop) || now() == Status::stopping;
        later = stops ? requests & kPause : 0;
    } while (!requests_.compare_exchange_weak(requests, later, std::memory_order_acquire, std::memory_order_relaxed));
    return requests & ~later;
}

void MachineStatus::fail(const oroforge::diag::Location& where, const std::string& why) {
    requests_.fetch_and(kStop, std::memory_order_relaxed);
    set(Status::error);
    observer_.failed(where, why);
}

}  // namespace RTT::scripting::detail
