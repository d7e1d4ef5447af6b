// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "workers.hpp"

#include <rtt/os/SignalsBlocked.hpp>
#include <rtt/os/fosi.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <list>
#include <map>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace OCL::live {
namespace {

constexpr unsigned kThreadsOfOne = 8;  // of one client
constexpr unsigned kThreads = 128;     // of all
constexpr unsigned kRequestsOfOne = 256;
constexpr std::chrono::seconds kIdle(5);

// Threads answer in time if they can, so the clock waits a little longer.
constexpr std::int64_t kGrace = 200000000;

/** False if the system refuses a thread. */
template <class Function>
bool startThread(Function function) {
    const RTT::os::SignalsBlocked blocked;
    try {
        std::thread(std::move(function)).detach();
        return true;
    } catch (const std::system_error&) {
        return false;
    }
}

void answer(const Job& job) {
    Ticket& ticket = *job.ticket;
    // What was reported as not done must not be done later.
    if (ticket.isOver()) return;
    if (rtos_get_time_ns() >= job.deadline) return ticket.fail(kNoAnswer, job.late);
    const WorkFor present(ticket);
    try {
        ticket.answer(job.run(job.deadline));
    } catch (const Failure& failure) {
        ticket.fail(failure.code(), failure.what());
    } catch (const std::exception& thrown) {
        ticket.fail(kFailed, thrown.what());
    } catch (...) {
        ticket.fail(kFailed, "something was thrown that is no std::exception");
    }
}

}  // namespace

struct Workers::State {
    struct Client {
        unsigned running = 0, all = 0;
    };

    std::mutex mutex;
    std::condition_variable work, clock;
    std::deque<Job> waiting;
    std::list<Job> pending;  ///< waiting or running; for the clock
    std::map<std::string, Client> clients;
    unsigned threads = 0, idle = 0;
    bool clockRuns = false, ends = false;

    /** With the lock held: the next request of a client that may have one more thread. */
    bool take(Job& job) {
        const auto next = std::find_if(waiting.begin(), waiting.end(), [this](const Job& each) {
            return clients[each.ticket->caller().name].running < kThreadsOfOne;
        });
        if (next == waiting.end()) return false;
        job = std::move(*next);
        waiting.erase(next);
        ++clients[job.ticket->caller().name].running;
        return true;
    }

    void release(const Job& job, bool ran) {
        const auto client = clients.find(job.ticket->caller().name);
        if (ran) --client->second.running;
        if (--client->second.all == 0) clients.erase(client);
        pending.remove_if([&](const Job& each) { return each.ticket == job.ticket; });
    }

    static void execute(const std::shared_ptr<State>& self) {
        std::unique_lock<std::mutex> lock(self->mutex);
        for (;;) {
            Job job;
            if (!self->ends && self->take(job)) {
                lock.unlock();
                answer(job);
                lock.lock();
                self->release(job, true);
                job = Job();
                continue;
            }
            if (self->ends) break;
            ++self->idle;
            const bool woken = self->work.wait_for(lock, kIdle) == std::cv_status::no_timeout;
            --self->idle;
            if (!woken && self->waiting.empty()) break;
        }
        --self->threads;
    }

    static void watch(const std::shared_ptr<State>& self) {
        std::unique_lock<std::mutex> lock(self->mutex);
        while (!self->ends && !self->pending.empty()) {
            const std::int64_t now = rtos_get_time_ns();
            std::int64_t next = now + std::chrono::nanoseconds(kIdle).count();
            std::list<Job> late;
            for (auto job = self->pending.begin(); job != self->pending.end();) {
                const std::int64_t end = job->deadline + kGrace;
                const auto following = std::next(job);
                if (end <= now)
                    late.splice(late.end(), self->pending, job);
                else
                    next = std::min(next, end);
                job = following;
            }
            if (late.empty()) {
                self->clock.wait_for(lock, std::chrono::nanoseconds(next - now));
                continue;
            }
            lock.unlock();
            for (const Job& job : late) job.ticket->fail(kNoAnswer, job.late);
            late.clear();
            lock.lock();
        }
        self->clockRuns = false;
    }
};

Workers::Workers() : state_(std::make_shared<State>()) {}

Workers::~Workers() {
    std::deque<Job> waiting;
    std::list<Job> pending;
    {
        const std::lock_guard<std::mutex> lock(state_->mutex);
        state_->ends = true;
        waiting.swap(state_->waiting);
        pending.swap(state_->pending);
    }
    state_->work.notify_all();
    state_->clock.notify_all();
}

void Workers::add(Job job) {
    State& state = *state_;
    const std::shared_ptr<Ticket> ticket = job.ticket;
    std::unique_lock<std::mutex> lock(state.mutex);
    State::Client& client = state.clients[ticket->caller().name];
    if (client.all == kRequestsOfOne) {
        lock.unlock();
        return ticket->fail(kTooMany, std::to_string(kRequestsOfOne) + " requests of this client are under way");
    }
    ++client.all;
    state.pending.push_back({ticket, nullptr, job.deadline, job.late});
    state.waiting.push_back(std::move(job));
    const bool clock = !state.clockRuns,
               thread = client.all <= kThreadsOfOne && state.idle < state.waiting.size() && state.threads < kThreads;
    state.clockRuns = true;
    if (thread) ++state.threads;
    lock.unlock();
    state.work.notify_one();
    state.clock.notify_one();
    const bool refusedThread = thread && !startThread([self = state_] { State::execute(self); });
    const bool refusedClock = clock && !startThread([self = state_] { State::watch(self); });
    if (!refusedThread && !refusedClock) return;
    lock.lock();
    if (refusedThread) --state.threads;
    if (refusedClock) state.clockRuns = false;
    if (state.threads != 0 && !refusedClock) return;  // another thread answers it
    lock.unlock();
    ticket->fail(kTooMany, "the system has no further thread");
}

}  // namespace OCL::live
