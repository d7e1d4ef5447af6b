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

/** The place of a call in a script, with its line for messages, which no thread of a component reads from the file. */
struct CallPlace {
    oroforge::diag::Location where;
    std::string line;  ///< empty: not known
};

/** Empty if the text has no such line. */
std::string lineOf(const std::string& text, unsigned line);

/** Tells of a call that failed, as the log has it: a warning, or an error. */
void logFailure(oroforge::diag::Severity severity, const CallPlace& place, const std::string& reasons);

/** A call that fails its statement: what has to be told first is its place, not that of what called the function it is in. */
class FailedCall : public std::runtime_error {
public:
    FailedCall(CallPlace place, const std::string& reasons) : std::runtime_error(reasons), place_(std::move(place)) {}

    /** On its way out of a function, say: `what` is so at a place that the one who catches this knows. */
    void leaves(std::string what) { left_ = std::move(what); }
    /** If it has left one, that was here. A place without file is one of whoever tells of this, unless it is said later. */
    void passes(CallPlace here);
    /** The file of the places without one, and its text. */
    void isFrom(const oroforge::diag::FileName& file, const std::string& text);

    const CallPlace& place() const { return place_; }
    /** `whole`: what failed for this reason, at `where`; empty: the statement there. */
    void report(oroforge::diag::Sink& sink, const oroforge::diag::Location& where, const std::string& whole) const;
    /** The lines of these places that are known; `text`: what is known of `file` besides. Nothing of them is read from disk. */
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
