// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "session.hpp"

#include "failure.hpp"

#include <cmath>
#include <cstdlib>

#include <unistd.h>

namespace oroforge::live_client {
namespace {

constexpr double kUsualLimit = 5, kLongestLimit = 86400;  // seconds

std::unique_ptr<Requests> connectToUrl(const std::string& url, std::chrono::milliseconds limit) {
    Address address = parseAddress(url);
    const char* const token = std::getenv("ORO_TOKEN");  // which other users do not see, unlike a command line
    if (token && *token && address.target.find("token=") == std::string::npos)
        address.target += (address.target.find('?') == std::string::npos ? "?token=" : "&token=") + std::string(token);
    return std::make_unique<Requests>(Connection::toAddress(address, deadlineIn(limit)),
                                      address.host + ":" + address.port, 0, limit);
}

}  // namespace

std::string Given::text(const std::string& key) const {
    const auto found = options.find(key);
    return found == options.end() ? std::string() : found->second;
}

double Given::number(const std::string& key, double otherwise, double least, double most) const {
    if (!has(key)) return otherwise;
    const std::string given = text(key);
    char* end = nullptr;
    const double value = std::strtod(given.c_str(), &end);
    if (given.empty() || *end || !(value >= least && value <= most)) {
        char range[64];
        std::snprintf(range, sizeof range, "%.10g and %.10g", least, most);
        throw Failure(Status::Usage, "--" + key + ": '" + given + "' is no number between " + range);
    }
    return value;
}

std::chrono::milliseconds timeLimitOf(const Given& given) {
    const double seconds = given.number("timeout", kUsualLimit, 0.001, kLongestLimit);
    return std::chrono::milliseconds(static_cast<long long>(std::ceil(seconds * 1000)));
}

std::unique_ptr<Requests> connectTo(const Deployment& deployment, std::chrono::milliseconds limit) {
    std::unique_ptr<Connection> connection;
    try {
        connection = Connection::toSocket(deployment.socket, deadlineIn(limit));
    } catch (const Failure&) {
        if (!deployment.pid || !isStopped(deployment.pid)) throw;
        const std::string pid = std::to_string(deployment.pid);
        throw Failure(Status::Refused, "deployment '" + deployment.name + "' (pid " + pid +
                                           ") does not answer: its process is stopped; 'kill -CONT " + pid +
                                           "' lets it go on");
    }
    return std::make_unique<Requests>(std::move(connection), deployment.name, deployment.pid, limit);
}

const std::string& Session::word(std::size_t index) const {
    static const std::string kNone;
    return index < given_.words.size() ? given_.words[index] : kNone;
}

Requests& Session::deployment() {
    if (requests_) return *requests_;
    const std::string url = given_.text("url");
    if (!url.empty() && given_.has("deployment"))
        throw Failure(Status::Usage, "--url and --deployment exclude each other: both choose a deployment");
    const std::chrono::milliseconds limit = timeLimitOf(given_);
    if (!url.empty()) {
        requests_ = connectToUrl(url, limit);
        return *requests_;
    }
    const char* const wanted = std::getenv("ORO_DEPLOYMENT");
    requests_ = connectTo(chosenDeployment(given_.has("deployment") ? given_.text("deployment")
                                           : wanted                 ? wanted
                                                                    : ""),
                          limit);
    return *requests_;
}

bool Session::answeredAsJson(const Json& result) {
    if (json()) out_.line(lineOf(result));
    return json();
}

void remark(const std::string& text) {
    const std::string line = "oro: " + text + "\n";
    if (::write(STDERR_FILENO, line.data(), line.size()) < 0) return;  // there is no other place to say it
}

}  // namespace oroforge::live_client
