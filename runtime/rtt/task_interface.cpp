// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The operations that every component has.
#include <rtt/TaskContext.hpp>

#include <rtt/internal/calls/standard_operations.hpp>

namespace RTT {

bool TaskContext::isStandardOperation(const std::string& name) { return internal::standardOperation(name) != nullptr; }

void TaskContext::addStandardOperations() {
    // Called through pointers to members of the base, so that overriding functions are found.
    addOperation("configure", &TaskContext::configure, this).doc("Makes the component ready to run (configureHook).");
    addOperation("isConfigured", &TaskContext::isConfigured, this).doc("Has the component been configured?");
    addOperation("start", &TaskContext::start, this).doc("Starts the component (startHook, then updateHook).");
    addOperation("activate", &TaskContext::activate, this).doc("Starts the activity of the component.");
    addOperation("stop", &TaskContext::stop, this).doc("Stops the component (stopHook).");
    addOperation("isRunning", &TaskContext::isRunning, this).doc("Is the component running?");
    addOperation("getPeriod", &TaskContext::getPeriod, this)
        .doc("The period in seconds; 0 if the activity is not periodic, -1 if there is none.");
    addOperation("setPeriod", &TaskContext::setPeriod, this)
        .doc("Changes the period of the activity.")
        .arg("s", "seconds; 0: not periodic");
    addOperation("getCpuAffinity", &TaskContext::getCpuAffinity, this)
        .doc("The processors the activity may run on, one bit each.");
    addOperation("setCpuAffinity", &TaskContext::setCpuAffinity, this)
        .doc("Changes the processors the activity may run on.")
        .arg("cpu", "one bit for each processor");
    addOperation("isActive", &TaskContext::isActive, this).doc("Is the activity of the component started?");
    addOperation("inFatalError", &TaskContext::inFatalError, this).doc("Has the component failed for good?");
    addOperation("error", &TaskContext::error, this)
        .doc("Enters the state RunTimeError (errorHook instead of updateHook).");
    addOperation("inRunTimeError", &TaskContext::inRunTimeError, this).doc("Is the component in state RunTimeError?");
    addOperation("inException", &TaskContext::inException, this).doc("Is the component in state Exception?");
    addOperation("cleanup", &TaskContext::cleanup, this).doc("Undoes configure() (cleanupHook).");
    addOperation("update", &TaskContext::update, this)
        .doc("Executes one step now, if the activity leaves that to others.");
    addOperation("trigger", &TaskContext::trigger, this)
        .doc("Executes one step soon, if the activity is not periodic.");
    addOperation("loadService", &TaskContext::loadService, this)
        .doc("Loads a service into this component.")
        .arg("service_name", "The name of the service");
}

}  // namespace RTT
