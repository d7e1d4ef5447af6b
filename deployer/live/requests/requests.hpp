// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What can be asked of a running deployment, without any socket. docs/design/live.md lists the verbs.
#ifndef OROFORGE_LIVE_REQUESTS_HPP
#define OROFORGE_LIVE_REQUESTS_HPP

#include "../rights.hpp"

#include <rtt/TaskContext.hpp>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace OCL::live {

struct Caller {
    std::string name;  ///< for the log; different for each connection: "oro of user 1000, process 4711"
    Rights rights;
};

/** What the deployment says of itself. */
struct Deployment {
    std::string name;
    std::vector<std::string> files;  ///< of the command line
    std::string version;             ///< of the toolchain
    std::int64_t started = 0;        ///< in ns since 1970
};

/** Takes {"op": "oro.answer", "id", "result"} or {"op": "oro.error", "id", "code", "message"}, all in UTF-8. Called
    once by any thread, perhaps within handle(); it must neither block nor throw nor destroy the Requests. Before that,
    a line of the console that is `live` gives {"op": "oro.output", "id", "text"} as often as it likes. */
using Answer = std::function<void(nlohmann::json)>;

/**
 * Answers requests. Its own threads do what may take time; one client has at most eight of them. What
 * touches the state of a component happens in the thread of that component; if nothing executes it, in one of these
 * threads, between two of its steps.
 *
 * Code of a component that does not return keeps its thread until the process ends, so the library that has this code
 * must not be unloaded.
 */
class Requests {
public:
    /** `stop` begins the orderly end of the deployment. It must not wait for that. */
    Requests(RTT::TaskContext& deployer, Deployment about, std::function<void()> stop);
    /** Waits for nothing but an answer that is being given. Later ones are dropped. */
    ~Requests();
    Requests(const Requests&) = delete;
    Requests& operator=(const Requests&) = delete;

    /** Never blocks and never throws. `request` may be any JSON. One thread at a time. */
    void handle(const nlohmann::json& request, const Caller& caller, Answer answer);
    /** The connection of that name has ended: its console ends, and nothing that it asked for is answered. The same
        thread as handle(). */
    void left(const std::string& caller);

private:
    struct State;
    const std::shared_ptr<State> state_;
};

}  // namespace OCL::live

#endif
