// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a command is executed with: its words and options, the output, and the deployment.
#ifndef OROFORGE_LIVE_CLIENT_SESSION_HPP
#define OROFORGE_LIVE_CLIENT_SESSION_HPP

#include "command.hpp"
#include "discovery.hpp"
#include "output.hpp"
#include "requests.hpp"

#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace oroforge::live_client {

/** The command line, by the table of commands. */
struct Given {
    const Command* command = nullptr;
    std::vector<std::string> words;
    std::map<std::string, std::string> options;  ///< by keyOf(); those without value are "true"

    bool has(const std::string& key) const { return options.count(key) != 0; }
    /** The value of an option; empty if it was not given. */
    std::string text(const std::string& key) const;
    /** The value as number within limits; `otherwise` if it was not given. A Failure if it is no such number. */
    double number(const std::string& key, double otherwise, double least, double most) const;
};

/** How long a request may take, from --timeout. */
std::chrono::milliseconds timeLimitOf(const Given& given);

/** Connects to that deployment of this computer and says hello. */
std::unique_ptr<Requests> connectTo(const Deployment& deployment, std::chrono::milliseconds limit);

class Session {
public:
    Session(const Given& given, Output& out) : given_(given), out_(out) {}

    const Given& given() const { return given_; }
    Output& out() { return out_; }
    const std::string& word(std::size_t index) const;
    /** Whether the answer is wanted as JSON. */
    bool json() const { return given_.text("format") == "json" || given_.has("json"); }
    /** The deployment that the options choose. Connects at the first call. */
    Requests& deployment();
    /** Asks, and writes the result as JSON if that is wanted; then true. */
    bool answeredAsJson(const Json& result);

private:
    const Given& given_;
    Output& out_;
    std::unique_ptr<Requests> requests_;
};

/** A warning or remark, on standard error. */
void remark(const std::string& text);

}  // namespace oroforge::live_client

#endif
