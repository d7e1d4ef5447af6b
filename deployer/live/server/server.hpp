// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_SERVER_HPP
#define OROFORGE_LIVE_SERVER_HPP

#include "../door/module.hpp"
#include "../requests/lookup.hpp"
#include "../requests/requests.hpp"
#include "../samples/log_lines.hpp"
#include "access.hpp"
#include "host.hpp"
#include "mailbox.hpp"
#include "transport.hpp"

#include <rtt/Activity.hpp>
#include <rtt/os/Semaphore.hpp>

#include <cstdint>
#include <map>
#include <memory>
#include <string>

namespace OCL::live {

/** Serves the clients of a deployment in a thread of its own, which sleeps as long as nobody says or watches
    anything. */
class Server final : public RunningServer, private RTT::Activity, private Reception, private Host {
public:
    explicit Server(const ServerStart& start);
    ~Server() override;

    /** False if there is no thread. */
    bool begin() { return started_ = start(); }

private:
    void loop() override;
    bool breakLoop() override { return true; }  // it is ending already
    // Reception
    Verdict judge(const RequestHead& head) override;
    std::unique_ptr<Client> welcome(const RequestHead& head, const std::string& protocol, const std::string& name,
                                    Link& link) override;
    void onTick() override;
    // Host
    void ask(std::uint64_t client, const nlohmann::json& request, const Caller& caller, Then then) override;
    void forward(std::uint64_t client, const nlohmann::json& request, const Caller& caller) override;
    std::unique_ptr<PortWatch> watch(const std::string& path, const PortWatch::Options& options) override;
    bool describe(const std::string& path, nlohmann::json& channel, std::string& why) override;
    void wantsChanged() override;
    class Guest;

    void deliverLines();
    void left(const LiveClient& client);
    LiveClient* find(std::uint64_t client);

    const Rights webMay_;
    const WebAccess web_;
    const Root root_;
    Transport transport_;
    const std::shared_ptr<Mailbox> mailbox_;
    std::unique_ptr<Requests> requests_;
    std::map<std::uint64_t, LiveClient*> clients_;
    std::uint64_t lastClient_ = 0;
    std::unique_ptr<LogLines> lines_;  // null while nobody follows the log
    std::uint64_t lostLines_ = 0;
    RTT::os::Semaphore done_{0};
    bool started_ = false;
};

}  // namespace OCL::live

#endif
