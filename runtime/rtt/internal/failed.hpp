// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How operations say why they return false.
#ifndef ORO_INTERNAL_FAILED_HPP
#define ORO_INTERNAL_FAILED_HPP

#include <rtt/Logger.hpp>
#include <rtt/internal/FailureReport.hpp>

#include <string>

namespace RTT {
namespace internal {

/** Gives the reason to the script that called, which reports it with the place of the call; without such a script, to the log.
    Returns false. */
inline bool failed(const std::string& why) {
    if (!FailureReport::give(why)) log(Error) << why << endlog();
    return false;
}

/** What `call` returns, which reports by itself why it fails, and may execute code of others: that does not give reasons to the
    script that called us. */
template <class Call>
bool reported(const std::string& why, Call call) {
    bool done = false;
    {
        const FailureReport::Pause others;
        done = call();
    }
    if (!done) (void)FailureReport::give(why);
    return done;
}

/** What `call` returns; if that is false, failed() with `why`, if it is not empty, and the errors that were logged meanwhile. */
template <class Call>
bool doneOr(const std::string& why, Call call) {
    bool done = false;
    std::string errors;
    {
        KeptErrors kept;
        done = call();
        errors = kept.take();
    }
    if (!done) return failed(errors.empty() ? why : why.empty() ? errors : why + ": " + errors);
    if (!errors.empty()) log(Error) << errors << endlog();
    return true;
}

/** What `call` returns, which logs why it fails, and may execute code of others. A script that called gets `why`, and what was
    logged. */
template <class Call>
bool toldOr(const std::string& why, Call call) {
    if (!FailureReport::isWanted()) return call();
    return doneOr(why, [&] {
        const FailureReport::Pause others;
        return call();
    });
}

}  // namespace internal
}  // namespace RTT

#endif
