// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The module with the server, which the door loads when the first client comes. In every deployment, it would cost
// milliseconds and megabytes.
#ifndef OROFORGE_LIVE_MODULE_HPP
#define OROFORGE_LIVE_MODULE_HPP

#include "../rights.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace RTT {
class TaskContext;
}

namespace OCL::live {

/** What the server is given. It owns the descriptors, of which each may be -1. */
struct ServerStart {
    RTT::TaskContext* deployer = nullptr;
    std::string name, version;
    std::vector<std::string> files;
    std::int64_t started = 0;    ///< when the program began, in ns since 1970
    std::function<void()> stop;  ///< ends the program in order; any thread
    int local = -1;              ///< a Unix socket that listens; whoever enters there may do everything
    int client = -1;             ///< one that has connected to it
    int web = -1;                ///< a TCP socket that listens
    std::string webAddress;      ///< its address, for messages
    std::string token;           ///< what clients of it must know
    bool webIsLoopback = true;
    Rights webMay;                        ///< `stop` and `console` are not for them in any case
    std::vector<std::string> webOrigins;  ///< sites whose pages may connect: "https://view.example"
};

/** A server with its thread. The destructor says farewell to its clients, for 0.2 s at most, and waits for the
    thread. */
class RunningServer {
public:
    virtual ~RunningServer() = default;
};

}  // namespace OCL::live

/** Null, with the reason, if the server does not start. Throws nothing. */
extern "C" OCL::live::RunningServer* oroLiveServe(const OCL::live::ServerStart& start, std::string& error) noexcept;

#endif
