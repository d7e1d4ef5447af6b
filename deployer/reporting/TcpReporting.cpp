// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/TcpReporting.hpp>

#include "tcp_listener.hpp"
#include "tcp_server.hpp"

#include <rtt/Logger.hpp>
#include <rtt/Property.hpp>
#include <rtt/PropertyBag.hpp>

#include <iostream>

namespace OCL {

using RTT::endlog;
using RTT::log;

namespace {

/** With less, no command would fit. */
constexpr unsigned int kShortestLine = 32;

}  // namespace

TcpReporting::TcpReporting(const std::string& name) : ReportingComponent(name) {
    addProperty("port", port_).doc("The port to listen on; if it is in use, one of the next four. 0: any free one.");
    addProperty("address", address_)
        .doc("The address to listen on: 127.0.0.1 for programs of this computer, 0.0.0.0 for all.");
    addProperty("max_clients", maxClients_).doc("How many clients there may be at a time.");
    addProperty("max_line", maxLine_).doc("Characters of the longest command.");
    addProperty("max_backlog", maxBacklog_)
        .doc("How much may wait for a client; frames for which there is no room are dropped. [bytes]");
    addAttribute("used_port", usedPort_);
    addAttribute("clients", clients_);
    addAttribute("refused_clients", refused_);
    addAttribute("dropped_frames", dropped_);
}

TcpReporting::~TcpReporting() { stopForGood(); }

bool TcpReporting::configureHook() {
    const auto* const data = dynamic_cast<RTT::Property<RTT::PropertyBag>*>(getProperty("ReportData"));
    return (data && data->rvalue().empty()) || ReportingComponent::configureHook();
}

bool TcpReporting::hasGoodLimits() const {
    const char* wrong = nullptr;
    if (maxClients_ == 0) wrong = "max_clients is 0; write how many clients there may be";
    if (maxLine_ < kShortestLine) wrong = "max_line is less than 32, which commands need";
    if (maxBacklog_ == 0) wrong = "max_backlog is 0; write how many bytes may wait for a client";
    if (wrong) log(RTT::Error) << "'" << getName() << "' cannot start: the property " << wrong << endlog();
    return !wrong;
}

bool TcpReporting::startHook() {
    writeTo(nullptr);  // a start that failed may have left a server
    usedPort_ = 0;
    counts_.reset();
    if (!hasGoodLimits()) return false;
    std::string error;
    reporting::TcpListener listener = reporting::listenOn(address_, port_, error);
    if (!error.empty()) {
        log(RTT::Error) << "'" << getName() << "' cannot listen: " << error << endlog();
        return false;
    }
    const unsigned int used = listener.port;
    reporting::TcpOptions options;
    options.component = getName();
    options.maxClients = maxClients_;
    options.limits.line = maxLine_;
    options.limits.backlog = maxBacklog_;
    const auto counts = std::make_shared<reporting::TcpCounts>();
    writeTo(std::make_unique<reporting::TcpServer>(std::move(listener), options, counts));
    if (!ReportingComponent::startHook()) {
        writeTo(nullptr);
        return false;
    }
    if (port_ != 0 && used != port_)
        log(RTT::Info) << "port " << port_ << " is in use: '" << getName() << "' uses port " << used << endlog();
    if (!reporting::isLoopback(address_))
        log(RTT::Info) << "'" << getName() << "' sends its report to any program that can connect to " << address_
                       << endlog();
    usedPort_ = used;
    counts_ = counts;
    updateCounts();
    return true;
}

void TcpReporting::updateHook() {
    ReportingComponent::updateHook();
    updateCounts();
}

void TcpReporting::stopHook() {
    ReportingComponent::stopHook();
    updateCounts();
    usedPort_ = 0;
}

void TcpReporting::updateCounts() {
    if (!counts_) return;
    clients_ = counts_->clients.load(std::memory_order_relaxed);
    refused_ = counts_->refused.load(std::memory_order_relaxed);
    dropped_ = counts_->dropped.load(std::memory_order_relaxed);
}

bool TcpReporting::screenComponent(const std::string& component) { return screenImpl(component, std::cerr); }

}  // namespace OCL
