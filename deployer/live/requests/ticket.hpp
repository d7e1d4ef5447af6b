// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_TICKET_HPP
#define OROFORGE_LIVE_TICKET_HPP

#include "failure.hpp"
#include "requests.hpp"

#include <atomic>
#include <memory>
#include <mutex>
#include <string>

namespace OCL::live {

/** Lets the answers to one client out until it is closed. */
class Outlet {
public:
    /** Waits for an answer that is being given; there are none afterwards. */
    void close();
    void give(const Answer& answer, nlohmann::json what);
    bool isClosed() const { return closed_; }

private:
    std::mutex mutex_;
    std::atomic<bool> closed_{false};
};

/** A request that is being answered: once, whoever is first. Any thread. */
class Ticket {
public:
    /** `request` has no dangerous depth. */
    Ticket(std::shared_ptr<Outlet> outlet, nlohmann::json request, Caller caller, Answer answer);

    const nlohmann::json& request() const { return request_; }
    const Caller& caller() const { return caller_; }
    /** Nobody needs an answer any more: there is one, or the client has left. */
    bool isOver() const { return answered_ || outlet_->isClosed(); }
    void answer(nlohmann::json result);
    void fail(const char* code, const std::string& message);
    /** Something on the way to the answer: {"op": "oro.output", "id", "text"}. */
    void say(const std::string& text);

private:
    void give(nlohmann::json what, bool isLast);

    const std::shared_ptr<Outlet> outlet_;
    const nlohmann::json request_;
    const Caller caller_;
    const Answer answer_;
    std::atomic<bool> answered_{false};
};

/** While it exists, this thread works for a ticket: what it waits for is given up when that is over. On the stack. */
class WorkFor {
public:
    explicit WorkFor(const Ticket& ticket);
    ~WorkFor();
    WorkFor(const WorkFor&) = delete;
    WorkFor& operator=(const WorkFor&) = delete;

    /** The ticket of this thread is over; false if it has none. */
    static bool isOver();
};

}  // namespace OCL::live

#endif
