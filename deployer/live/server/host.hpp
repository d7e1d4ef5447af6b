// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_HOST_HPP
#define OROFORGE_LIVE_HOST_HPP

#include "../requests/requests.hpp"
#include "../samples/port_watch.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace OCL::live {

class LiveClient;

/** What the server offers its clients. Its functions are called by the thread of the transport. */
class Host {
public:
    typedef std::function<void(LiveClient& client, const nlohmann::json& answer)> Then;
    /** Asks on behalf of a client; `then` gets the answer, unless the client has gone. */
    virtual void ask(std::uint64_t client, const nlohmann::json& request, const Caller& caller, Then then) = 0;
    /** Asks, and gives the answer to the client as it is. */
    virtual void forward(std::uint64_t client, const nlohmann::json& request, const Caller& caller) = 0;
    /** Watches "Arm.service.port". Throws Failure if it cannot be watched. */
    virtual std::unique_ptr<PortWatch> watch(const std::string& path, const PortWatch::Options& options) = 0;
    /** A client wants ticks or lines of the log, or does not any more. */
    virtual void wantsChanged() = 0;

protected:
    ~Host() = default;
};

}  // namespace OCL::live

#endif
