// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Requests of the protocol (docs/design/live.md), and what comes back.
#ifndef OROFORGE_LIVE_CLIENT_REQUESTS_HPP
#define OROFORGE_LIVE_CLIENT_REQUESTS_HPP

#include "connection.hpp"
#include "json.hpp"

#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include <sys/types.h>

namespace oroforge::live_client {

class Requests {
public:
    /** What happened while it waited. */
    enum class Event { Message, Time, Woken };

    /** `name` and `pid` (0: not on this computer) are for messages; no request waits longer than `limit`. */
    Requests(std::unique_ptr<Connection> connection, std::string name, pid_t pid, std::chrono::milliseconds limit);

    /** Sends `oro.<verb>` and waits for its answer. Throws a Refusal if the deployment reports an error, and a Failure
        if it does not answer in time or ends. Messages that are not the answer wait for next(). */
    Json ask(const std::string& verb, Json fields = Json::object()) { return ask(verb, std::move(fields), limit_); }
    Json ask(const std::string& verb, Json fields, std::chrono::milliseconds limit);

    /** Sends a request; its answer comes from next(). Returns its id. */
    long long send(const std::string& verb, Json fields);
    /** Waits for the next message. Throws a Failure if the deployment ends, or sends what is no message. */
    Event next(Json& message, Deadline deadline);
    /** The result of an answer; throws the Refusal of an error. */
    static Json resultOf(const Json& answer);

    /** Binary messages go to this function as they come, while any function waits. Without it, they are ignored. */
    void onBytes(std::function<void(std::string_view message)> take) { takeBytes_ = std::move(take); }

    Connection& connection() { return *connection_; }
    const std::string& name() const { return name_; }
    pid_t pid() const { return pid_; }
    std::chrono::milliseconds limit() const { return limit_; }
    /** Throws the Failure that there was no answer within that time. */
    [[noreturn]] void reportSilence(std::chrono::milliseconds limit) const;
    /** Whether a message is the answer, or the error, to the request `id`. */
    static bool answers(const Json& message, long long id);

private:
    Event receive(Json& message, Deadline deadline);
    std::string where() const;

    std::unique_ptr<Connection> connection_;
    const std::string name_;
    const pid_t pid_;
    const std::chrono::milliseconds limit_;
    long long last_ = 0;
    std::deque<Json> waiting_;
    std::function<void(std::string_view)> takeBytes_;
};

/** `limit` from now; never if that is later than a clock can say. */
Deadline deadlineIn(std::chrono::milliseconds limit);

}  // namespace oroforge::live_client

#endif
