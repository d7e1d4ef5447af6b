// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/calls/failure_report.hpp>

#include <rtt/Logger.hpp>
#include <rtt/internal/calls/sending.hpp>

#include <atomic>
#include <mutex>
#include <set>

namespace RTT::internal {

namespace {

// Initial-exec: a real-time thread reads innermostErrors with each error, and must not allocate then.
thread_local FailureReport* innermostReport __attribute__((tls_model("initial-exec"))) = nullptr;
thread_local KeptErrors* innermostErrors __attribute__((tls_model("initial-exec"))) = nullptr;
thread_local FailureReport* reportOfSent __attribute__((tls_model("initial-exec"))) = nullptr;
std::atomic<bool> strict{false};

struct Services {
    std::mutex mutex;
    std::set<const Service*> all;
};

/** Never destroyed: components may outlive static objects. */
Services& services() {
    static Services& known = *new Services;
    return known;
}

/** Once only: several attempts may fail for the same reason. */
void append(std::string& text, const std::string& more) {
    if (text.find(more) == std::string::npos) text += (text.empty() ? "" : "; ") + more;
}

}  // namespace

FailureReport::FailureReport() noexcept : outer_(innermostReport) { innermostReport = this; }
FailureReport::~FailureReport() { innermostReport = outer_; }

bool FailureReport::give(const std::string& reason) {
    if (!innermostReport) return false;
    append(innermostReport->reasons_, reason);
    return true;
}

bool FailureReport::isWanted() noexcept { return innermostReport != nullptr; }

FailureReport::Pause::Pause() noexcept : paused_(innermostReport) {
    innermostReport = std::exchange(reportOfSent, nullptr);
}
FailureReport::Pause::~Pause() { innermostReport = paused_; }

FailureReport::OfSent::OfSent(FailureReport& report) noexcept { reportOfSent = &report; }
FailureReport::OfSent::~OfSent() { reportOfSent = nullptr; }

void FailureReport::add(const Service& service) {
    const std::lock_guard<std::mutex> lock(services().mutex);
    services().all.insert(&service);
}

void FailureReport::remove(const Service& service) {
    const std::lock_guard<std::mutex> lock(services().mutex);
    services().all.erase(&service);
}

bool FailureReport::comesFrom(const Service& service) {
    const std::lock_guard<std::mutex> lock(services().mutex);
    return services().all.count(&service) != 0;
}

void FailureReport::setStrict(bool yes) noexcept { strict.store(yes, std::memory_order_relaxed); }
bool FailureReport::isStrict() noexcept { return strict.load(std::memory_order_relaxed); }

Sending::Watcher::~Watcher() = default;
void Sending::announce(Sending next) noexcept { announced = next; }

KeptErrors::KeptErrors() noexcept : outer_(innermostErrors) { innermostErrors = this; }

KeptErrors::~KeptErrors() {
    innermostErrors = outer_;
    if (!text_.empty()) log(Error) << text_ << endlog();
}

bool KeptErrors::keep(const std::string& line) {
    if (!innermostErrors) return false;
    append(innermostErrors->text_, line);
    return true;
}

}  // namespace RTT::internal
