// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Commands that show messages as they come, until Ctrl-C.
#ifndef OROFORGE_LIVE_CLIENT_FOLLOW_HPP
#define OROFORGE_LIVE_CLIENT_FOLLOW_HPP

#include "session.hpp"

#include <functional>
#include <string>

namespace oroforge::live_client {

/** What a command does meanwhile. Both return false to end. */
struct Follower {
    std::function<bool(const Json& message)> each;  ///< for each message of the request
    std::function<bool()> tick = {};                ///< each `interval`; none if empty
    std::chrono::milliseconds interval{1000};
    std::function<void()> begin = {};  ///< once, when the deployment has accepted
};

/** Sends the request, then gives its messages, whose `op` is that, to the follower. Returns at
    Ctrl-C, too; throws if the deployment refuses or ends. */
void follow(Session& session, const std::string& verb, const Json& fields, const std::string& op,
            const Follower& follower);

/** A port, and the part of its samples that is wanted. */
struct PortPath {
    std::string port, field;
};

/** Splits `arm.out.pose.x` where the port ends, by asking the deployment. Throws its Refusal if there is no port. */
PortPath findPort(Session& session, const std::string& path);

/** Follows the samples of the port that the first word names: `each` gets the message and the wanted part of its value,
    chosen by the path and by --field. */
void followPort(Session& session, const Json& fields, const std::function<bool(const Json&, const Json&)>& each,
                const std::function<bool()>& tick = {}, std::chrono::milliseconds interval = std::chrono::seconds(1));

}  // namespace oroforge::live_client

#endif
