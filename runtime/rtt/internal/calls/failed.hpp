// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// For operations: reports why they return false.
#ifndef ORO_INTERNAL_FAILED_HPP
#define ORO_INTERNAL_FAILED_HPP

#include <rtt/Logger.hpp>
#include <rtt/internal/calls/failure_report.hpp>

#include <string>

namespace RTT {
namespace internal {

/** Gives the reason to the calling script, which reports it with the place of the call, or logs it if there is none.
    Returns false. */
inline bool failed(const std::string& why) {
    if (!FailureReport::give(why)) log(Error) << why << endlog();
    return false;
}

/** Returns the result of `call`, which itself reports why it fails. It may execute code of other components, which
    gives no reasons to our calling script. */
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

/** Returns the result of `call`. If it is false, calls failed() with `why`, if any, and the errors logged meanwhile. */
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

/** Returns the result of `call`, which logs why it fails and may execute code of other components. A calling script
    gets `why` and the logged errors. */
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
