// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TASKBROWSER_HPP
#define ORO_TASKBROWSER_HPP

#include <ocl/OCL.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/rtt-config.h>

#include <memory>
#include <string>

namespace OCL {

/**
 * A console that shows a component and its peers and commands them.
 *
 *     OCL::TaskBrowser browser(&component);
 *     browser.loop();
 *
 * With a terminal on standard input and output it has a prompt, history, completion and colours; otherwise it reads commands
 * from standard input, and writes nothing but what they give. docs/console.md describes what can be typed.
 *
 * It connects no port of a component by looking at it. Not real-time; all functions are for one thread at a time. The
 * component may be destroyed before the browser, which then ends.
 */
class OCL_API TaskBrowser : public RTT::TaskContext {
public:
    enum ColorTheme { nocolors, darkbg, whitebg };

    /** With the colours for a dark background on a terminal, unless the environment has a NO_COLOR that is not empty. */
    explicit TaskBrowser(RTT::TaskContext* component);
    explicit TaskBrowser(RTT::TaskContext& component) : TaskBrowser(&component) {}
    ~TaskBrowser() override;

    /** Reads and executes lines until `quit` or the end of the input. SIGTERM and SIGHUP stop the command that is being
        executed and end it, too; SIGINT as well, but on a terminal it stops no more than a command. */
    void loop();
    /** For programs that catch signals themselves: loop() ends as soon as this descriptor can be read. On a terminal it has
        SIGINT while a command is executed, and Ctrl-C at the prompt; otherwise their handler gets it. */
    void endOn(int descriptor);

    /** True if loop() read lines from what is no terminal, and one of them could not be executed. All others were. */
    bool failed() const;

    /** True if standard input and output are a terminal. */
    static bool onTerminal();

    void setColorTheme(ColorTheme theme);
    /** Executes one line as if it had been typed. */
    void evaluate(const std::string& line);
    void evalCommand(const std::string& line) { evaluate(line); }
    /** Goes to that component. */
    void switchTaskContext(RTT::TaskContext* component);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace OCL

#endif
