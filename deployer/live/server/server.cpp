// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "server.hpp"

#include "find_port.hpp"
#include "live_client.hpp"
#include "oro_messages.hpp"

#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

namespace OCL::live {
namespace {

using nlohmann::json;

std::int64_t monotonicTime() {
    return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

}  // namespace

/** A client that the server knows as long as it exists. */
class Server::Guest final : public Client {
public:
    Guest(Server& server, std::uint64_t number, Caller caller, Link& link, bool speaksFoxglove)
        : server_(server), client_(server, number, std::move(caller), link, speaksFoxglove) {
        server_.clients_.emplace(number, &client_);
    }
    ~Guest() override { server_.left(client_); }

    void receive(std::string_view message, bool isBinary) override { client_.receive(message, isBinary); }
    bool next(Frame& frame) override { return client_.next(frame); }
    bool isFull() const override { return client_.isFull(); }

private:
    Server& server_;
    LiveClient client_;
};

Server::Server(const ServerStart& start)
    : RTT::Activity(ORO_SCHED_OTHER, 0, 0.0, nullptr, "live window"),
      webMay_(start.webMay),
      web_{start.token, start.webIsLoopback, start.webOrigins},
      root_{start.deployer->engine()->gate(), start.deployer->getName()},
      transport_(*this),
      mailbox_(std::make_shared<Mailbox>(transport_)),
      requests_(std::make_unique<Requests>(
          *start.deployer, Deployment{start.name, start.files, start.version, start.started}, start.stop)) {
    if (start.local >= 0) transport_.listen(start.local, /*isLocal=*/true);
    if (start.web >= 0) transport_.listen(start.web, /*isLocal=*/false);
    if (start.client >= 0) transport_.add(start.client, /*isLocal=*/true);
}

Server::~Server() {
    if (started_) {
        transport_.stop();
        done_.wait();
        (void)stop();
    }
    mailbox_->close();
    lines_.reset();
    requests_.reset();
}

void Server::loop() {
    transport_.run();
    done_.signal();
}

Verdict Server::judge(const RequestHead& head) { return judgeRequest(head, web_); }

std::unique_ptr<Client> Server::welcome(const RequestHead& head, const std::string& protocol, const std::string& name,
                                        Link& link) {
    const std::uint64_t number = ++lastClient_;
    const Rights rights = head.isLocal
                              ? Rights{true, true, true, true, true}
                              : Rights{webMay_.properties, webMay_.operations, webMay_.lifecycle, false, false};
    RTT::log(RTT::Info) << "live window: client " << number << " is " << name << RTT::endlog();
    auto guest = std::make_unique<Guest>(*this, number, Caller{name + ", client " + std::to_string(number), rights},
                                         link, !protocol.empty() && protocol != kOro);
    wantsChanged();
    return guest;
}

void Server::left(const LiveClient& client) {
    clients_.erase(client.number());
    requests_->left(client.caller().name);
    wantsChanged();
}

LiveClient* Server::find(std::uint64_t client) {
    const auto found = clients_.find(client);
    return found == clients_.end() ? nullptr : found->second;
}

void Server::ask(std::uint64_t client, const json& request, const Caller& caller, Then then) {
    requests_->handle(request, caller, [this, client, then = std::move(then), mailbox = mailbox_](json answer) {
        mailbox->put([this, client, then, answer = std::move(answer)] {
            if (LiveClient* const asker = find(client)) then(*asker, answer);
        });
    });
}

void Server::forward(std::uint64_t client, const json& request, const Caller& caller) {
    const bool isLine = request.value("op", json()) == "oro.line";
    requests_->handle(request, caller, [this, client, isLine, mailbox = mailbox_](const json& answer) {
        const bool isOutput = answer.value("op", "") == "oro.output";
        // Written here: large values would keep the server's thread from other clients.
        mailbox->put(
            [this, client, isLine, isOutput, id = answer.value("id", json()), text = textOf(answer)]() mutable {
                LiveClient* const asker = find(client);
                if (asker && isOutput) asker->output(std::move(text));
                if (asker && !isOutput) asker->forwarded(id, std::move(text), isLine);
            });
    });
}

std::unique_ptr<PortWatch> Server::watch(const std::string& path, const PortWatch::Options& options) {
    return watchPort(root_, path, options);
}

bool Server::describe(const std::string& path, json& channel, std::string& why) {
    RTT::encoding::SchemaText schema;
    try {
        if (!describePort(root_, path, schema, why)) return false;
    } catch (const Failure& failure) {
        why = failure.what();
        return false;
    }
    channel = {
        {"encoding", "cdr"}, {"schemaName", schema.name}, {"schema", schema.text}, {"schemaEncoding", schema.encoding}};
    return true;
}

void Server::onTick() {
    const std::int64_t now = monotonicTime();
    // A client that has nothing left to watch changes what the others want, not which there are.
    for (const auto& [number, client] : clients_) client->onTick(now);
}

void Server::wantsChanged() {
    unsigned period = 0;
    bool wantsLines = false;
    for (const auto& [number, client] : clients_) {
        const unsigned wanted = client->wantedPeriod();
        if (wanted != 0) period = period == 0 ? wanted : std::min(period, wanted);
        wantsLines = wantsLines || client->wantsLines();
    }
    transport_.tick(std::chrono::milliseconds(period));
    if (wantsLines && !lines_)
        lines_ = std::make_unique<LogLines>([this, mailbox = mailbox_] { mailbox->put([this] { deliverLines(); }); });
    else if (!wantsLines)
        lines_.reset();
}

void Server::deliverLines() {
    if (!lines_) return;
    const std::vector<LogLine> lines = lines_->take(lostLines_);
    for (const auto& [number, client] : clients_) client->onLines(lines, lostLines_);
}

}  // namespace OCL::live
