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

private:
    std::mutex mutex_;
    bool closed_ = false;
};

/** A request that is being answered: once, whoever is first. Any thread. */
class Ticket {
public:
    /** `request` has no dangerous depth. */
    Ticket(std::shared_ptr<Outlet> outlet, nlohmann::json request, Caller caller, Answer answer);

    const nlohmann::json& request() const { return request_; }
    const Caller& caller() const { return caller_; }
    bool isAnswered() const { return answered_; }
    void answer(nlohmann::json result);
    void fail(const char* code, const std::string& message);

private:
    void give(nlohmann::json what);

    const std::shared_ptr<Outlet> outlet_;
    const nlohmann::json request_;
    const Caller caller_;
    const Answer answer_;
    std::atomic<bool> answered_{false};
};

}  // namespace OCL::live

#endif
