// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/watch.hpp>

#include <rtt/Activity.hpp>
#include <rtt/Logger.hpp>
#include <rtt/transports/corba/corba.h>
#include <rtt/transports/corba/detail/serving.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <utility>
#include <vector>

namespace RTT::corba::detail {

struct Watch::Entry {
    std::recursive_mutex mutex;  // of the function, which may destroy its watch
    std::function<void()> check;
    std::atomic<bool> isSlow{false};  // it waits for a process that hangs
    std::atomic<bool> isBusy{false};
};

namespace {

constexpr Seconds kPeriod = 1.0;

typedef std::shared_ptr<Watch::Entry> Entry;

constexpr std::chrono::milliseconds kSlow{200};

void callOf(Watch::Entry& entry) {
    const std::lock_guard<std::recursive_mutex> lock(entry.mutex);
    const std::function<void()> check = entry.check;
    if (!check) return;
    const auto begin = std::chrono::steady_clock::now();
    try {
        check();
    } catch (const CORBA::Exception& error) {
        log(Error) << "another process cannot be watched: " << error._name() << endlog();
    } catch (const std::exception& thrown) {
        log(Error) << "another process cannot be watched: " << thrown.what() << endlog();
    }
    entry.isSlow = std::chrono::steady_clock::now() - begin > kSlow;
}

/** So that others do not wait for this one. */
void callAside(const Entry& entry) {
    if (entry->isBusy.exchange(true)) return;
    executeAside([entry] {
        callOf(*entry);
        entry->isBusy = false;
    });
}

class Watcher final : public Activity {
public:
    Watcher() : Activity(ORO_SCHED_OTHER, 0, kPeriod, 0, nullptr, "CorbaWatch") { setStopTimeout(10); }

    void add(const Entry& entry) {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            entries_.push_back(entry);
        }
        if (!isActive()) (void)start();
    }
    void remove(const Entry& entry) {
        const std::lock_guard<std::mutex> lock(mutex_);
        entries_.erase(std::remove(entries_.begin(), entries_.end(), entry), entries_.end());
    }

    void end() {
        (void)stop();
        for (const Entry& one : entries()) {
            const std::lock_guard<std::recursive_mutex> executing(one->mutex);
        }
    }

protected:
    void step() override {
        const std::vector<Entry> all = entries();
        for (const Entry& one : all)
            if (one->isSlow)
                callAside(one);
            else
                callOf(*one);
    }

private:
    std::vector<Entry> entries() {
        const std::lock_guard<std::mutex> lock(mutex_);
        return entries_;
    }
    std::mutex mutex_;
    std::vector<Entry> entries_;
};

Watcher& watcher() {
    static auto* const watcher = new Watcher();  // never destroyed: it may be executing when the process ends
    return *watcher;
}

}  // namespace

Watch::Watch(std::function<void()> check) : entry_(std::make_shared<Entry>()) {
    entry_->check = std::move(check);
    watcher().add(entry_);
}

Watch::~Watch() {
    watcher().remove(entry_);
    const std::lock_guard<std::recursive_mutex> lock(entry_->mutex);
    entry_->check = nullptr;
}

void endWatches() { watcher().end(); }

}  // namespace RTT::corba::detail
