// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "ticket.hpp"

#include "fields.hpp"

#include <rtt/Logger.hpp>

#include <exception>
#include <utility>

namespace OCL::live {
namespace {
thread_local const Ticket* ticketOfThread = nullptr;
}

void Outlet::close() {
    const std::lock_guard<std::mutex> lock(mutex_);
    closed_ = true;
}

void Outlet::give(const Answer& answer, nlohmann::json what) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (closed_ || !answer) return;
    try {
        answer(std::move(what));
    } catch (const std::exception& thrown) {
        RTT::log(RTT::Error) << "an answer to a client is lost: " << thrown.what() << RTT::endlog();
    }
}

Ticket::Ticket(std::shared_ptr<Outlet> outlet, nlohmann::json request, Caller caller, Answer answer)
    : outlet_(std::move(outlet)),
      request_(std::move(request)),
      caller_(std::move(caller)),
      answer_(std::move(answer)) {}

void Ticket::answer(nlohmann::json result) { give({{"op", "oro.answer"}, {"result", std::move(result)}}, true); }

void Ticket::fail(const char* code, const std::string& message) {
    give({{"op", "oro.error"}, {"code", code}, {"message", message}}, true);
}

void Ticket::say(const std::string& text) { give({{"op", "oro.output"}, {"text", text}}, false); }

void Ticket::give(nlohmann::json what, bool isLast) {
    if (isLast ? answered_.exchange(true) : answered_.load()) return;
    const auto id = request_.is_object() ? request_.find("id") : request_.end();
    what["id"] = id == request_.end() ? nlohmann::json() : *id;
    makeUtf8(what);
    outlet_->give(answer_, std::move(what));
}

WorkFor::WorkFor(const Ticket& ticket) { ticketOfThread = &ticket; }
WorkFor::~WorkFor() { ticketOfThread = nullptr; }
bool WorkFor::isOver() { return ticketOfThread && ticketOfThread->isOver(); }

}  // namespace OCL::live
