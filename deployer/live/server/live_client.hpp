// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_LIVE_CLIENT_HPP
#define OROFORGE_LIVE_LIVE_CLIENT_HPP

#include "../samples/log_lines.hpp"
#include "host.hpp"
#include "message_queue.hpp"
#include "oro_streams.hpp"
#include "transport.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace OCL::live {

class FoxgloveSession;

/** One client: reads its messages and collects what it gets. Used by the thread of the transport only. */
class LiveClient final : public Client {
public:
    /** `speaksFoxglove`: it gets what Foxglove's protocol sends without being asked. */
    LiveClient(Host& host, std::uint64_t number, Caller caller, Link& link, bool speaksFoxglove);
    ~LiveClient() override;

    void receive(std::string_view message, bool isBinary) override;
    bool next(Frame& frame) override { return queue_.next(frame); }
    bool isFull() const override;

    const Caller& caller() const { return caller_; }
    std::uint64_t number() const { return number_; }
    Host& host() { return host_; }
    /** See Host::ask(). */
    void ask(const nlohmann::json& request, Host::Then then) { host_.ask(number_, request, caller_, std::move(then)); }
    MessageQueue& queue() { return queue_; }

    void sendText(std::string text);
    void sendBinary(std::string bytes);
    /** The answer to something that was forwarded, a line of the console or another request. */
    void forwarded(const nlohmann::json& id, std::string text, bool isLine);
    /** Output of a line that is being executed. */
    void output(std::string text);

    void onTick(std::int64_t now);
    void onLines(const std::vector<LogLine>& lines, std::uint64_t dropped);
    /** In ms; 0: it wants none. */
    unsigned wantedPeriod() const;
    bool wantsLines() const;

private:
    void receiveText(std::string_view text);
    void receiveOro(const nlohmann::json& message, const std::string& op);

    Host& host_;
    const std::uint64_t number_;
    const Caller caller_;
    Link& link_;
    MessageQueue queue_;
    OroStreams streams_;
    std::unique_ptr<FoxgloveSession> foxglove_;  // null: it speaks oro.v1 only
    unsigned outstanding_ = 0;                   // forwarded, not answered
};

}  // namespace OCL::live

#endif
