// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "requests.hpp"

#include "discovery.hpp"
#include "failure.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace oroforge::live_client {
namespace {

constexpr const char* kAnswer = "oro.answer";
constexpr const char* kError = "oro.error";
constexpr double kOfDeployment = 0.8;  // part of the time limit
constexpr const char* kPrefix = "oro.";
constexpr std::size_t kLongestRequest = 64 * 1024;  // that a deployment takes

/** "2 s", "0.5 s". */
std::string seconds(std::chrono::milliseconds limit) {
    char text[32];
    std::snprintf(text, sizeof text, "%g s", static_cast<double>(limit.count()) / 1000);
    return text;
}

}  // namespace

Deadline deadlineIn(std::chrono::milliseconds limit) {
    const Deadline now = Clock::now();
    return limit > std::chrono::duration_cast<std::chrono::milliseconds>(kNever - now) ? kNever : now + limit;
}

Requests::Requests(std::unique_ptr<Connection> connection, std::string name, pid_t pid, std::chrono::milliseconds limit)
    : connection_(std::move(connection)), name_(std::move(name)), pid_(pid), limit_(limit) {}

std::string Requests::where() const {
    return "deployment '" + name_ + "'" + (pid_ ? " (pid " + std::to_string(pid_) + ")" : "");
}

void Requests::reportSilence(std::chrono::milliseconds limit) const {
    std::string text = where() + " does not answer within " + seconds(limit);
    if (pid_ && isStopped(pid_))
        text += ": its process is stopped; 'kill -CONT " + std::to_string(pid_) + "' lets it go on";
    else
        text += "; --timeout gives it more time";
    throw Failure(Status::Refused, text);
}

bool Requests::answers(const Json& message, long long id) {
    const std::string op = textOf(message, "op");
    return (op == kAnswer || op == kError) && wholeOf(message, "id", -1) == id;
}

Json Requests::resultOf(const Json& answer) {
    if (textOf(answer, "op") == kError) throw Refusal(textOf(answer, "code"), textOf(answer, "message"));
    return memberOf(answer, "result");
}

long long Requests::send(const std::string& verb, Json fields) {
    Json request = {{"op", kPrefix + verb}, {"id", ++last_}};
    for (auto& field : fields.items()) request[field.key()] = std::move(field.value());
    const std::string line = lineOf(request);
    if (line.size() > kLongestRequest)
        throw Failure(Status::Refused, "the request '" + verb + "' has " + std::to_string(line.size()) +
                                           " bytes, more than the " + std::to_string(kLongestRequest) +
                                           " that a deployment takes");
    if (!connection_->send(line, deadlineIn(limit_))) reportSilence(limit_);
    return last_;
}

Json Requests::ask(const std::string& verb, Json fields, std::chrono::milliseconds limit) {
    const Deadline deadline = deadlineIn(limit);
    // The deployment knows better what takes so long, so its report comes first.
    constexpr double kLongest = 3600;
    const double seconds = std::min(static_cast<double>(limit.count()) / 1000 * kOfDeployment, kLongest);
    if (!fields.contains("timeout")) fields["timeout"] = seconds;
    const long long id = send(verb, std::move(fields));
    for (Json message;;) {
        const Event event = receive(message, deadline);
        if (event == Event::Time) reportSilence(limit);
        if (event == Event::Woken) throw Interrupted();
        if (answers(message, id)) return resultOf(message);
        waiting_.push_back(std::move(message));
    }
}

Requests::Event Requests::next(Json& message, Deadline deadline) {
    if (waiting_.empty()) return receive(message, deadline);
    message = std::move(waiting_.front());
    waiting_.pop_front();
    return Event::Message;
}

Requests::Event Requests::receive(Json& message, Deadline deadline) {
    for (std::string text;;) {
        message = nullptr;
        switch (connection_->receive(text, deadline)) {
            case Connection::Event::Time: return Event::Time;
            case Connection::Event::Woken: return Event::Woken;
            case Connection::Event::Broken: throw NobodyReads();
            case Connection::Event::Closed: {
                const std::string why = connection_->reason();
                throw Ended(where() + (why.empty() ? " has ended" : " ended the connection: " + why));
            }
            case Connection::Event::Bytes:
                if (takeBytes_) takeBytes_(text);
                // They may come without a pause.
                if (Clock::now() >= deadline) return Event::Time;
                continue;
            case Connection::Event::Message: break;
        }
        message = parsed(text);
        if (!message.is_object())
            throw Failure(Status::Refused,
                          where() + " sends a message that is no JSON object; is its version another?");
        // Messages of other protocols on the same connection mean nothing here.
        if (textOf(message, "op").compare(0, std::string(kPrefix).size(), kPrefix) == 0) return Event::Message;
    }
}

}  // namespace oroforge::live_client
