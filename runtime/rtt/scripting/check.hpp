// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_CHECK_HPP
#define ORO_SCRIPTING_CHECK_HPP

#include <rtt/rtt-config.h>

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace RTT {
class TaskContext;

namespace scripting {

/** What a script may find when it runs that does not exist when it is checked. Kept from one script to the next. */
struct Expectations {
    bool names = false;                 ///< any components, services, operations and values
    bool types = false;                 ///< any types of values
    bool globals = false;               ///< any global services, operations and values
    std::set<std::string> components;   ///< peers of the component that runs the script, with unknown interfaces
    std::set<std::string> definitions;  ///< functions, programs, state machines and their types, from earlier scripts
    std::set<const TaskContext*> more;  ///< components that may get additional names
    bool begun = false;                 ///< the script has done more than load and declare
    bool doubts = false;                ///< warn of unknown names that are similar to known ones

    void anything() { names = types = globals = true; }
    /** Expects the effects of unknown code that cannot reach the component that runs the script. */
    void anyGlobals() { types = globals = true; }
};

/** What is known of an argument that is not a literal text. */
struct ForeseenArgument {
    std::optional<double> number;                  ///< a literal number
    std::string name;                              ///< a plain name, such as ORO_SCHED_RT
    std::optional<std::vector<std::string>> list;  ///< strings(…) with literal texts
};

/** A call that a script makes. */
struct ForeseenCall {
    std::vector<std::string> path;          ///< {"arm", "configure"}
    std::vector<const std::string*> texts;  ///< the arguments that are literal texts; null for others
    std::vector<ForeseenArgument> others;   ///< what is known of the other ones
    bool certain = true;                    ///< it is made in any case, and before what follows
    bool ignored = false;                   ///< the script ignores its result
    std::string script;                     ///< the file of the call
    unsigned line = 0;                      ///< its line there
};

/** What is wrong with a call, or what it runs. */
struct CallProblem {
    static constexpr std::size_t kNoArgument = ~std::size_t{0};
    std::string text;                    ///< empty if nothing is wrong
    const char* code = "";               ///< "DEP031"
    std::size_t argument = kNoArgument;  ///< the argument in question
    bool isWarning = false;
    std::string script;  ///< if nothing is wrong: a file that the checked component runs, which is checked as well
};

/** Foresees the effects of calls of known operations. For one thread. */
class RTT_API CallForecast {
public:
    virtual ~CallForecast();
    /** Adds the effects of a call, or brings them about, so that what follows can be checked. Called in the order of
        the script. */
    virtual CallProblem foresee(const ForeseenCall& call, Expectations& expected) = 0;
};

/**
 * Checks a script for `component` without executing it. Writes diagnostics, in the form of a compiler's, to `messages`.
 * True if there are no errors.
 *
 * If the syntax is right, names, types and arguments are looked up: in the component, its peers and services as they
 * are now, and in what the script itself defines. After a statement that calls an operation, which may create
 * components, types or services, an unknown name is not an error any more; wrong arguments and types are. A forecast
 * can say more about such calls, and about scripts that the script runs.
 *
 * During the check, no other thread may use the interface of the component, which temporarily gets a service for each
 * program and state machine of the script. Any thread; not real-time safe; calls no operation unless the forecast does.
 */
RTT_API bool checkScript(const std::string& file, TaskContext& component, std::ostream& messages);
RTT_API bool checkScript(const std::string& file, TaskContext& component, std::ostream& messages,
                         CallForecast& forecast, Expectations& expected);

/** The same for a text, which messages call `name`. */
RTT_API bool checkScriptText(const std::string& text, const std::string& name, TaskContext& component,
                             std::ostream& messages);

}  // namespace scripting
}  // namespace RTT

#endif
