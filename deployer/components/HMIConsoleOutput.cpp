// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/HMIConsoleOutput.hpp>

#include <rtt/Logger.hpp>
#include <rtt/os/MutexLock.hpp>

#include <iostream>
#include <unistd.h>

namespace OCL {
namespace {

const char* const kBlue = "\033[1;34m";
const char* const kPlain = "\033[0m";

}  // namespace

HMIConsoleOutput::HMIConsoleOutput(const std::string& name)
    : RTT::TaskContext(name), prompt_("HMIConsoleOutput :\n"), color_(isatty(STDOUT_FILENO) != 0) {
    addOperation("display", &HMIConsoleOutput::display, this).doc("Shows a text.").arg("message", "The text");
    addOperation("displayBool", &HMIConsoleOutput::displayBool, this).doc("Shows 0 or 1.").arg("boolean", "The value");
    addOperation("displayInt", &HMIConsoleOutput::displayInt, this).doc("Shows a number.").arg("integer", "The number");
    addOperation("displayDouble", &HMIConsoleOutput::displayDouble, this)
        .doc("Shows a number.")
        .arg("double", "The number");
    addOperation("log", &HMIConsoleOutput::log, this).doc("Logs a text.").arg("message", "The text");
    addOperation("logBool", &HMIConsoleOutput::logBool, this).doc("Logs 0 or 1.").arg("boolean", "The value");
    addOperation("logInt", &HMIConsoleOutput::logInt, this).doc("Logs a number.").arg("integer", "The number");
    addOperation("logDouble", &HMIConsoleOutput::logDouble, this).doc("Logs a number.").arg("double", "The number");
}

HMIConsoleOutput::~HMIConsoleOutput() { stopForGood(); }

void HMIConsoleOutput::enableColor(bool on) {
    const RTT::os::MutexLock lock(mutex_);
    color_ = on;
}

void HMIConsoleOutput::setPrompt(const std::string& prompt) {
    const RTT::os::MutexLock lock(mutex_);
    prompt_ = prompt;
}

void HMIConsoleOutput::enqueueText(const std::string& text) {
    {
        const RTT::os::MutexLock lock(mutex_);
        messages_ += text;
        messages_ += '\n';
    }
    (void)trigger();
}

void HMIConsoleOutput::updateHook() {
    std::string text;
    {
        const RTT::os::MutexLock lock(mutex_);
        if (messages_.empty()) return;
        text = color_ ? kBlue + prompt_ + kPlain : prompt_;
        text += messages_;
        messages_.clear();
    }
    std::cout << text << std::endl;
}

void HMIConsoleOutput::log(const std::string& message) { RTT::log(RTT::Info) << message << RTT::endlog(); }
void HMIConsoleOutput::logBool(bool boolean) { RTT::log(RTT::Info) << boolean << RTT::endlog(); }
void HMIConsoleOutput::logInt(int integer) { RTT::log(RTT::Info) << integer << RTT::endlog(); }
void HMIConsoleOutput::logDouble(double number) { RTT::log(RTT::Info) << number << RTT::endlog(); }

}  // namespace OCL
