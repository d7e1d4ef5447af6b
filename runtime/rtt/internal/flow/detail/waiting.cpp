// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/flow/detail/waiting.hpp>

#include <rtt/internal/engine/detail/message_pause.hpp>
#include <rtt/internal/flow/reclaimer.hpp>
#include <rtt/os/futex.hpp>

#include <algorithm>

namespace RTT::internal::detail {

std::atomic<std::uint32_t> Waiting::number_{0};
std::atomic<std::uint32_t> Waiting::changes_{0};

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
    {
        const std::lock_guard<std::mutex> lock(mutex());
        calls_.first_ = calls_.last_ = nullptr;
        calls_.batches_ = &parked_;
        all().push_back(this);
    }
    // From now on no thread waits for this one. It counts itself before it looks whether its own wait is over, so a
    // thread that ends the wait finds it, or it finds that the wait is over.
    if (number_.fetch_add(1) != 0) wakeAll();
}

Waiting::~Waiting() {
    number_.fetch_sub(1);
    const std::lock_guard<std::mutex> lock(mutex());
    all().erase(std::find(all().begin(), all().end(), this));
    calls_.batches_ = parked_.outer;
    calls_.prepend(parked_.first);
}

void Waiting::sleep(std::uint32_t seen, bool executesMessages) const {
    if (executesMessages && !Reclaimer::inside())
        pauseForMessages(changes_, seen);
    else
        os::detail::futexWait(changes_, seen, os::detail::kForever);
}

void Waiting::wakeAll() noexcept {
    changes_.fetch_add(1, std::memory_order_release);
    os::detail::futexWakeAll(changes_);
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
