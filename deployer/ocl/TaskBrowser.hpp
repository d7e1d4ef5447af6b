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
 * A console that shows and commands a component and its peers.
 *
 *     OCL::TaskBrowser browser(&component);
 *     browser.loop();
 *
 * On a terminal it has a prompt, history, completion and colours. Otherwise it reads commands from standard input and
 * writes only their results. docs/console.md describes the commands.
 *
 * It never connects a port by showing it. Not real-time; only one thread at a time may call its functions. The
 * component may be destroyed before the browser, which then ends.
 */
class OCL_API TaskBrowser : public RTT::TaskContext {
public:
    enum ColorTheme { nocolors, darkbg, whitebg };

    /** Uses the colours for a dark background on a terminal, unless the environment variable NO_COLOR is set and not
        empty. */
    explicit TaskBrowser(RTT::TaskContext* component);
    explicit TaskBrowser(RTT::TaskContext& component) : TaskBrowser(&component) {}
    ~TaskBrowser() override;

    /** Reads and executes lines until `quit` or the end of the input. SIGTERM, SIGHUP and SIGINT stop the current
        command and end the loop; on a terminal, SIGINT only stops the command. */
    void loop();
    /**
     * For programs that catch signals themselves: loop() ends when this descriptor becomes readable. On a terminal the
     * console handles SIGINT while a command is executed, and Ctrl-C at the prompt; otherwise the handler of the
     * program gets it.
     */
    void endOn(int descriptor);

    /** True if loop() did not read from a terminal and a line could not be executed. It executes all other lines. */
    bool failed() const;

    /** True if standard input and output are a terminal. */
    static bool onTerminal();

    void setColorTheme(ColorTheme theme);
    /** Executes one line as if it had been typed. */
    void evaluate(const std::string& line);
    void evalCommand(const std::string& line) { evaluate(line); }
    /** Visits that component. */
    void switchTaskContext(RTT::TaskContext* component);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace OCL

#endif
