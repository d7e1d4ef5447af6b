// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_WORKERS_HPP
#define OROFORGE_LIVE_WORKERS_HPP

#include "ticket.hpp"

#include <cstdint>
#include <functional>
#include <memory>

namespace OCL::live {

/** A request and how it is answered: by the result of `run`, or the Failure that it throws. */
struct Job {
    std::shared_ptr<Ticket> ticket;
    std::function<nlohmann::json(std::int64_t deadline)> run;
    std::int64_t deadline = 0;  ///< monotonic, in ns: run() must not wait any longer
    std::string late;           ///< the message after that: "component 'a' did not answer within 1 s"
};

/**
 * Threads in which requests are answered, made when they are needed; they end when there has been nothing to do for
 * some seconds. A request whose thread does not come back in time is answered with an error, and the thread goes on.
 */
class Workers {
public:
    Workers();
    /** Waits for nothing: threads end when their request is done. */
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    /** Answers with an error if the client has too many requests under way. Never blocks. */
    void add(Job job);

private:
    struct State;
    const std::shared_ptr<State> state_;
};

}  // namespace OCL::live

#endif
