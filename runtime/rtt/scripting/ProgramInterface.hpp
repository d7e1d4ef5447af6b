// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_PROGRAM_INTERFACE_HPP
#define ORO_SCRIPTING_PROGRAM_INTERFACE_HPP

#include <rtt/base/ExecutableInterface.hpp>
#include <rtt/scripting/rtt-scripting-fwd.hpp>

#include <boost/enable_shared_from_this.hpp>

#include <string>

namespace RTT {
namespace scripting {

/**
 * A program that an engine executes, as scripts define them; users may write their own and give it to
 * ScriptingService::loadProgram(). The engine calls execute() once in every step that is due to time or input, but for
 * programs that have nothing to do: isIdle() and wake().
 *
 * The commands may be called by any thread, also by the program itself. They never block and are real-time safe. They are
 * false, and do nothing, while no engine has the program. What they do, and what they return otherwise:
 *
 *     is        start()       pause()             step()                stop()
 *     stopped   runs anew     paused at its       false                 true
 *                             first statement
 *     running   false         paused              false                 stopped
 *     paused    goes on       true                executes a statement  stopped
 *     error     false         paused              false                 stopped
 *
 * stop() and start() count at once; pause() and step() in the next step of the engine, or after the statement that is
 * being executed. step() may follow a pause() that has not been done yet; it is false while an earlier step() is still to
 * come. After stop() at most the statement that was being executed is finished.
 */
class RTT_API ProgramInterface : public base::ExecutableInterface,
                                 public boost::enable_shared_from_this<ProgramInterface> {
public:
    struct Status {
        enum ProgramStatus { unknown, stopped, paused, running, error };
    };
    typedef Status::ProgramStatus ProgramStatus;

    ~ProgramInterface() override;

    virtual const std::string& getName() const = 0;
    virtual bool start() = 0;
    virtual bool pause() = 0;
    virtual bool step() = 0;
    virtual bool stop() = 0;
    /** Back to the first statement: what stop() does. */
    bool reset() { return stop(); }
    /** Any thread; real-time safe. */
    virtual ProgramStatus getStatus() const = 0;
    /** The line of the statement that comes next, or failed; 0 if there is none. Any thread; real-time safe. */
    virtual int getLineNumber() const = 0;
    /** The text it was made of. */
    virtual std::string getText() const;
    /** The line of its file that this text begins in, by which getLineNumber() counts; 1 if that is not known. */
    virtual int getFirstLine() const;
    /** Why it failed, with the place; empty unless inError(). Any thread; allocates. */
    virtual std::string getError() const;

    bool isRunning() const { return getStatus() == Status::running; }
    bool isPaused() const { return getStatus() == Status::paused; }
    bool isStopped() const { return getStatus() == Status::stopped; }
    bool inError() const { return getStatus() == Status::error; }
    /** The name of the status, such as "running". */
    std::string getProgramStatusStr() const;
};

}  // namespace scripting
}  // namespace RTT

#endif
