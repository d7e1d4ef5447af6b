// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What ends a command of oro before it is done.
#ifndef OROFORGE_LIVE_CLIENT_FAILURE_HPP
#define OROFORGE_LIVE_CLIENT_FAILURE_HPP

#include <stdexcept>
#include <string>

namespace oroforge::live_client {

/** The exit status of the program. */
enum class Status { Done = 0, Refused = 1, Usage = 2, NoDeployment = 3 };

/** The text says what, where and what to do, without a period. */
class Failure : public std::runtime_error {
public:
    Failure(Status status, const std::string& text) : std::runtime_error(text), status_(status) {}
    Status status() const { return status_; }

private:
    Status status_;
};

/** The deployment answered a request with an error; the text begins with its code in brackets. */
class Refusal : public Failure {
public:
    Refusal(std::string code, const std::string& message)
        : Failure(Status::Refused, (code.empty() ? "" : "[" + code + "] ") + message),
          code_(std::move(code)),
          message_(message) {}
    const std::string& code() const { return code_; }
    const std::string& message() const { return message_; }

private:
    std::string code_, message_;
};

/** The deployment has ended the connection. */
class Ended : public Failure {
public:
    explicit Ended(const std::string& text) : Failure(Status::Refused, text) {}
};

/** Ends with that status; what was wrong has been written. */
struct Silent {
    Status status;
};

/** Ctrl-C was pressed while a command that ends so waited for an answer. */
struct Interrupted {};

/** Nobody reads the output any more, as after `| head -1`: the program ends without a word. */
struct NobodyReads {};

}  // namespace oroforge::live_client

#endif
