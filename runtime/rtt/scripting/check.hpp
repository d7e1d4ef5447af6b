// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_CHECK_HPP
#define ORO_SCRIPTING_CHECK_HPP

#include <rtt/rtt-config.h>

#include <cstddef>
#include <iosfwd>
#include <set>
#include <string>
#include <vector>

namespace RTT {
class TaskContext;

namespace scripting {

/** What a script may find when it runs, beyond what is there when it is checked. Kept from one script to the next. */
struct Expectations {
    bool names = false;                 ///< components, services, operations, values, of whatever name
    bool types = false;                 ///< types of values
    bool globals = false;               ///< what belongs to no component: services, operations, values
    std::set<std::string> components;   ///< peers of the component that runs the script, whose interface nobody knows
    std::set<std::string> definitions;  ///< functions, programs, state machines and their types of scripts before
    std::set<const TaskContext*> more;  ///< components that may have more than they have now
    bool begun = false;                 ///< the script has done more than load and declare
    bool doubts = false;                ///< unknown names that are like known ones get a warning

    void anything() { names = types = globals = true; }
    /** Code of which nothing is known is executed, with no way to the component that runs the script. */
    void anyGlobals() { types = globals = true; }
};

/** A call that a script makes. */
struct ForeseenCall {
    std::vector<std::string> path;  ///< {"arm", "configure"}
    std::vector<const std::string*>
        texts;             ///< of each argument that is a text as it stands there; null: something else
    bool certain = true;   ///< it is made in any case, and before what stands behind it
    bool ignored = false;  ///< the script does not look at its result
    std::string script;    ///< the file in which it stands
    unsigned line = 0;     ///< and where
};

/** What is wrong with a call, or what it runs. */
struct CallProblem {
    static constexpr std::size_t kNoArgument = ~std::size_t{0};
    std::string text;                    ///< empty: nothing
    const char* code = "";               ///< "DEP031"
    std::size_t argument = kNoArgument;  ///< which argument that is about
    bool isWarning = false;
    std::string
        script;  ///< nothing is wrong: the component that is checked runs this file, which is looked through as well
};

/** What calls lead to, for somebody who knows the operations. One thread. */
class RTT_API CallForecast {
public:
    virtual ~CallForecast();
    /** Adds what the call may lead to, or has it happen, so that what comes behind it can be checked. In the order of the script. */
    virtual CallProblem foresee(const ForeseenCall& call, Expectations& expected) = 0;
};

/**
 * Tells what is wrong with a script for `component`, without executing any of it. Messages have the form of a compiler's, and
 * are written to `messages`. True if there are no errors.
 *
 * If its syntax is right, names, types and arguments are looked up: in the component, its peers and services as they are
 * now, and among what the script itself defines. As soon as a statement calls an operation, which may create components,
 * types or services, a name that nobody knows is no error any more; wrong arguments and types still are. A forecast can
 * tell more of such calls, and of scripts that the script runs.
 *
 * While this is being executed nobody else may use the interface of the component, which gets a service for each program and
 * state machine of the script, and loses it at the end. Any thread; not real-time safe; calls no operation, but for what the
 * forecast does.
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
