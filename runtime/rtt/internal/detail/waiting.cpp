// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/detail/waiting.hpp>

#include <rtt/internal/Reclaimer.hpp>

#include <algorithm>

namespace RTT::internal::detail {

// Never destroyed: components with static storage may still remove ports while the process exits.
std::mutex& Waiting::mutex() {
    static std::mutex* one = new std::mutex;
    return *one;
}

std::vector<Waiting*>& Waiting::all() {
    static std::vector<Waiting*>* list = new std::vector<Waiting*>;
    return *list;
}

Waiting::Waiting() : calls_(Reclaimer::deferred()), parked_{calls_.first_, nullptr, calls_.batches_} {
    const std::lock_guard<std::mutex> lock(mutex());
    calls_.first_ = calls_.last_ = nullptr;
    calls_.batches_ = &parked_;
    all().push_back(this);
}

Waiting::~Waiting() {
    const std::lock_guard<std::mutex> lock(mutex());
    all().erase(std::find(all().begin(), all().end(), this));
    calls_.batches_ = parked_.outer;
    calls_.prepend(parked_.first);
}

bool Waiting::has(pthread_t thread) {
    const std::lock_guard<std::mutex> lock(mutex());
    return std::any_of(all().begin(), all().end(),
                       [thread](const Waiting* one) { return pthread_equal(one->thread_, thread); });
}

unsigned Waiting::takeOver(const void* argument) {
    const std::lock_guard<std::mutex> lock(mutex());
    unsigned taken = 0;
    for (Waiting* const one : all())
        if (!pthread_equal(one->thread_, pthread_self()))
            taken += one->calls_.cancel(&one->parked_, argument) + DeferredCalls::abandon(&one->parked_, argument);
    return taken;
}

unsigned Waiting::cancel(const void* argument) {
    const std::lock_guard<std::mutex> lock(mutex());
    return Reclaimer::deferred().cancel(argument);
}

unsigned Waiting::making(const void* argument) {
    const std::lock_guard<std::mutex> lock(mutex());
    return Reclaimer::deferred().making(argument);
}

unsigned Waiting::abandon(const void* argument) {
    const std::lock_guard<std::mutex> lock(mutex());
    return Reclaimer::deferred().abandon(argument);
}

}  // namespace RTT::internal::detail
