// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/watch.hpp>

#include <rtt/Activity.hpp>
#include <rtt/Logger.hpp>
#include <rtt/transports/corba/corba.h>

#include <algorithm>
#include <exception>
#include <mutex>
#include <utility>
#include <vector>

namespace RTT::corba::detail {

struct Watch::Entry {
    std::recursive_mutex mutex;  // of the function, which may destroy its watch
    std::function<void()> check;
};

namespace {

constexpr Seconds kPeriod = 1.0;

typedef std::shared_ptr<Watch::Entry> Entry;

void callOf(Watch::Entry& entry) {
    const std::lock_guard<std::recursive_mutex> lock(entry.mutex);
    const std::function<void()> check = entry.check;
    if (!check) return;
    try {
        check();
    } catch (const CORBA::Exception& error) {
        log(Error) << "another process cannot be watched: " << error._name() << endlog();
    } catch (const std::exception& thrown) {
        log(Error) << "another process cannot be watched: " << thrown.what() << endlog();
    }
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

protected:
    void step() override {
        std::vector<Entry> all;
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            all = entries_;
        }
        for (const Entry& one : all) callOf(*one);
    }

private:
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

void endWatches() { (void)watcher().stop(); }

}  // namespace RTT::corba::detail
