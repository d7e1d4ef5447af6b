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
 * Executes pieces of script that a user types at the console of a component, each at once and in the thread of the
 * caller. A piece may have several statements and definitions.
 *
 * Variables and constants become attributes of the component, visible to its scripts and to users. Aliases and handles
 * of sent calls live as long as this object. Functions, programs and state machines go to the component's service
 * "scripting", which is loaded for them.
 *
 * Not real-time; used by one thread at a time. The component may be destroyed before this object, see alive().
 */
class RTT_API TypedInput {
public:
    /** The result of the last statement. */
    struct Answer {
        enum Kind {
            None,   ///< a statement other than an expression
            Void,   ///< a call without a result
            Value,  ///< the value of an expression or of a declared variable
        } kind = None;
        base::DataSourceBase::shared_ptr value;  ///< for Value: a copy that does not change
    };

    /** Messages call the text `name`. */
    TypedInput(TaskContext& component, std::string name);
    ~TypedInput();

    /** False after the component was destroyed; then nothing may be executed any more. */
    bool alive() const;

    /**
     * Executes a text whose first line has the number `line`, which grows from call to call. If it has syntax errors,
     * or a statement fails, writes errors with their places to `messages` and returns false; earlier statements keep
     * their effects. Also writes warnings.
     */
    bool execute(const std::string& text, unsigned line, std::ostream& messages, Answer& answer);

    /** True if the text continues in the next line, because a brace, parenthesis, bracket or comment is open. */
    static bool goesOn(const std::string& text);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace scripting
}  // namespace RTT

#endif
