// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_TYPED_INPUT_HPP
#define ORO_SCRIPTING_TYPED_INPUT_HPP

#include <rtt/base/DataSourceBase.hpp>
#include <rtt/rtt-config.h>

#include <iosfwd>
#include <memory>
#include <string>

namespace RTT {
class TaskContext;

namespace scripting {

/**
 * Pieces of script that somebody types, one after the other, for one component: a console. Each is executed at once, in the
 * thread of the caller, and may consist of several statements and definitions.
 *
 * Variables and constants become attributes of the component, so that its scripts and whoever looks at it see them; aliases
 * and handles of sent calls are known as long as this object lives. Functions, programs and state machines go to the
 * component's service "scripting", which is loaded for them.
 *
 * Not real-time; for one thread at a time. The component may be destroyed before this object, see alive().
 */
class RTT_API TypedInput {
public:
    /** What the last statement gave. */
    struct Answer {
        enum Kind {
            None,   ///< a statement that is no expression
            Void,   ///< a call without result
            Value,  ///< of an expression, or of a variable that was declared
        } kind = None;
        base::DataSourceBase::shared_ptr value;  ///< a copy that stays as it is; of Value only
    };

    /** `name` stands for the text in messages. */
    TypedInput(TaskContext& component, std::string name);
    ~TypedInput();

    /** False once the component was destroyed; then nothing may be executed any more. */
    bool alive() const;

    /** Executes a text whose first line has the number `line`, which grows from call to call. False, and errors with their
        places in `messages`, if it has syntax errors, or once a statement cannot be executed; what came before it is done.
        Warnings are written there as well. */
    bool execute(const std::string& text, unsigned line, std::ostream& messages, Answer& answer);

    /** True if the text goes on in the next line: a brace, parenthesis, bracket or comment is open. */
    static bool goesOn(const std::string& text);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace scripting
}  // namespace RTT

#endif
