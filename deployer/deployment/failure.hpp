// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How operations of the deployer say why they return false.
#ifndef OROFORGE_DEPLOYMENT_FAILURE_HPP
#define OROFORGE_DEPLOYMENT_FAILURE_HPP

#include <rtt/Logger.hpp>
#include <rtt/internal/FailureReport.hpp>

#include <string>

namespace OCL::deploy {

/** Gives the reason to the script that called, which reports it with the place of the call; without such a script, to the log.
    Returns false. */
inline bool failed(const std::string& why) {
    if (!RTT::internal::FailureReport::give(why)) RTT::log(RTT::Error) << why << RTT::endlog();
    return false;
}

/** What `call` returns, which reports by itself why it fails, and may execute code of others: that does not give reasons to the
    script that called us. */
template <class Call>
bool reported(const std::string& why, Call call) {
    bool done = false;
    {
        const RTT::internal::FailureReport::Pause others;
        done = call();
    }
    if (!done) (void)RTT::internal::FailureReport::give(why);
    return done;
}

/** What `call` returns; if that is false, failed() with `why`, if it is not empty, and the errors that were logged meanwhile. */
template <class Call>
bool doneOr(const std::string& why, Call call) {
    bool done = false;
    std::string errors;
    {
        RTT::internal::KeptErrors kept;
        done = call();
        errors = kept.take();
    }
    if (!done) return failed(errors.empty() ? why : why.empty() ? errors : why + ": " + errors);
    if (!errors.empty()) RTT::log(RTT::Error) << errors << RTT::endlog();
    return true;
}

}  // namespace OCL::deploy

#endif
