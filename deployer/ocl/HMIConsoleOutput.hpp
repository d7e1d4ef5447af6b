// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_HMI_CONSOLE_OUTPUT_HPP
#define ORO_OCL_HMI_CONSOLE_OUTPUT_HPP

#include <ocl/OCL.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/os/Mutex.hpp>
#include <rtt/rtt-config.h>

#include <sstream>
#include <string>

namespace OCL {

/** Shows messages of other components on the console, in its own thread while it runs. */
class OCL_API HMIConsoleOutput : public RTT::TaskContext {
public:
    explicit HMIConsoleOutput(const std::string& name = "cout");
    ~HMIConsoleOutput() override;

    /** Turns the blue prompt on or off; by default it is on for a terminal. */
    void enableColor(bool on);
    /** Sets the text before messages. */
    void setPrompt(const std::string& prompt);
    /** Keeps a message until the next cycle, and triggers that. Allocates; may be called from any thread. */
    template <class T>
    void enqueue(const T& message) {
        std::ostringstream text;
        text << message;
        enqueueText(text.str());
    }

    // The operations, executed in the thread of the caller. Those named log… write to the log at level Info.
    void display(const std::string& message) { enqueueText(message); }
    void displayBool(bool boolean) { enqueue(boolean); }
    void displayInt(int integer) { enqueue(integer); }
    void displayDouble(double number) { enqueue(number); }
    void log(const std::string& message);
    void logBool(bool boolean);
    void logInt(int integer);
    void logDouble(double number);

protected:
    void updateHook() override;

private:
    void enqueueText(const std::string& text);

    RTT::os::Mutex mutex_;
    std::string messages_;  // waiting for the next cycle
    std::string prompt_;
    bool color_;
};

}  // namespace OCL

#endif
