// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_FAILED_CALL_HPP
#define ORO_SCRIPTING_DETAIL_FAILED_CALL_HPP

#include <diag/sink.hpp>
#include <diag/source_cache.hpp>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace RTT::scripting::detail {

/** The place of a call in a script. It has the line for messages, because threads of components must not read the
    file. */
struct CallPlace {
    oroforge::diag::Location where;
    std::string line;  ///< empty if unknown
};

/** The line of that number; empty if the text has no such line. */
std::string lineOf(const std::string& text, unsigned line);

/** Logs a failed call as a warning or error. */
void logFailure(oroforge::diag::Severity severity, const CallPlace& place, const std::string& reasons);

/** The failure of a call that fails its statement. It is reported at its own place, not where its function was
    called. */
class FailedCall : public std::runtime_error {
public:
    FailedCall(CallPlace place, const std::string& reasons) : std::runtime_error(reasons), place_(std::move(place)) {}

    /** Notes that the exception leaves a function, or other code that `what` names; the code that catches it knows the
        place. */
    void leaves(std::string what) { left_ = std::move(what); }
    /** Sets the place of what it left. A place without a file belongs to the code that reports this, unless isFrom()
        sets it. */
    void passes(CallPlace here);
    /** Sets the file, and its text, of places without one. */
    void isFrom(const oroforge::diag::FileName& file, const std::string& text);

    const CallPlace& place() const { return place_; }
    /** Reports it. `whole` names what failed for this reason at `where`; empty means the statement there. */
    void report(oroforge::diag::Sink& sink, const oroforge::diag::Location& where, const std::string& whole) const;
    /** Adds the known lines of its places to the sources; `text` is the known text of `file`. Reads nothing from
        disk. */
    void addLines(oroforge::diag::SourceCache& sources, const std::string& file, const std::string& text) const;

private:
    struct Call {
        CallPlace place;
        std::string what;
    };
    CallPlace place_;
    std::string left_;
    std::vector<Call> calls_;
};

}  // namespace RTT::scripting::detail

#endif
