// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/later.hpp>

#include <rtt/Activity.hpp>
#include <rtt/Logger.hpp>
#include <rtt/transports/corba/corba.h>

#include <deque>
#include <exception>
#include <mutex>
#include <utility>

namespace RTT::corba::detail {

namespace {

constexpr Seconds kPatience = 5;

class Helper final : public Activity {
public:
    Helper() : Activity(nullptr, "CorbaHelper") { setStopTimeout(kPatience); }

    void add(std::function<void()> work) {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            work_.push_back(std::move(work));
        }
        if (!isActive()) (void)start();
        (void)trigger();
    }
    /** Blocks until the work is done, or for some seconds. The next work begins it again. */
    void end() {
        // What came too late for the thread is done here, unless the thread does not get on.
        if (stop()) executeAll();
        const std::lock_guard<std::mutex> lock(mutex_);
        work_.clear();
    }

protected:
    void loop() override { executeAll(); }
    bool breakLoop() override { return true; }  // the end of the work is soon

private:
    void executeAll() {
        while (const std::function<void()> next = take()) {
            try {
                next();
            } catch (const CORBA::Exception&) {
                // The other process is gone, and what it should have learned with it.
            } catch (const std::exception& thrown) {
                log(Error) << "a connection with another process does not end as it should: " << thrown.what()
                           << endlog();
            }
        }
    }
    std::function<void()> take() {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (work_.empty()) return {};
        std::function<void()> next = std::move(work_.front());
        work_.pop_front();
        return next;
    }
    std::mutex mutex_;
    std::deque<std::function<void()>> work_;
};

Helper& helper() {
    static auto* const helper = new Helper();  // never destroyed: other threads may use it until the process ends
    return *helper;
}

}  // namespace

void later(std::function<void()> work) { helper().add(std::move(work)); }
void endLater() { helper().end(); }

}  // namespace RTT::corba::detail
