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
 * A program that an engine executes. Scripts define programs; C++ code may derive its own and give it to
 * ScriptingService::loadProgram(). The engine calls execute() once in every step that is due to time or input, except
 * for programs that have nothing to do: isIdle() and wake().
 *
 * Any thread, and the program itself, may call the commands. They never block and are real-time safe. While no engine
 * has the program, they return false and do nothing. Otherwise:
 *
 *     is        start()       pause()             step()                stop()
 *     stopped   runs anew     paused at its       false                 true
 *                             first statement
 *     running   false         paused              false                 stopped
 *     paused    goes on       true                executes a statement  stopped
 *     error     false         paused              false                 stopped
 *
 * stop() and start() take effect at once; pause() and step() in the next step of the engine, or after the current
 * statement. step() may follow a pause() that has not taken effect; it is false if an earlier step() has not. After
 * stop(), at most the current statement is finished.
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
    /** Goes back to the first statement, as stop() does. */
    bool reset() { return stop(); }
    /** May be called from any thread; real-time safe. */
    virtual ProgramStatus getStatus() const = 0;
    /** The line of the statement that is next, or that failed; 0 if there is none. Any thread; real-time safe. */
    virtual int getLineNumber() const = 0;
    /** The source text. */
    virtual std::string getText() const;
    /** The line in its file where this text begins; getLineNumber() counts from there. 1 if unknown. */
    virtual int getFirstLine() const;
    /** Why and where it failed; empty unless inError(). Any thread; allocates. */
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
