// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/base/TaskCore.hpp>

#include <rtt/ExecutionEngine.hpp>
#include <rtt/Logger.hpp>
#include <rtt/base/ActivityInterface.hpp>

#include <exception>

namespace RTT {
namespace base {

TaskCore::TaskCore(TaskState initial_state, const std::string& name)
    : ee(new ExecutionEngine(this)),
      mTaskState(initial_state),
      mTargetState(initial_state),
      mInitialState(initial_state),
      name_(name) {}

TaskCore::~TaskCore() {
    if (ee->getActivity()) ee->getActivity()->stop();
    delete ee;
}

const std::string& TaskCore::getName() const { return name_; }

void TaskCore::setState(TaskState state) {
    mTargetState = state;
    mTaskState = state;
}

// Calls a hook that decides about a change of state. A hook that changes the state itself and yet answers true
// contradicts itself; that is treated like an exception.
template <class Hook>
TaskCore::Outcome TaskCore::callHook(const char* function, TaskState during, Hook hook) {
    const TaskState target = mTargetState;
    try {
        if (!hook()) return Outcome::Refused;
        if (mTaskState == during && mTargetState == target) return Outcome::Accepted;
        log(Error) << getName() << ": the hook of " << function
                   << " changed the state of the component and returned true" << endlog();
    } catch (const std::exception& e) {
        log(Error) << getName() << ": the hook of " << function << " threw: " << e.what() << endlog();
    } catch (...) {
        log(Error) << getName() << ": the hook of " << function << " threw something that is no std::exception"
                   << endlog();
    }
    exception();
    return Outcome::Threw;
}

bool TaskCore::configure() {
    const TaskState from = mTaskState;
    if (from != Stopped && from != PreOperational) return false;
    mTargetState = Stopped;
    switch (callHook("configure()", from, [this] { return configureHook(); })) {
        case Outcome::Accepted: setState(Stopped); return true;
        case Outcome::Refused:
            if (mTaskState == from) setState(PreOperational);
            return false;
        case Outcome::Threw: break;
    }
    return false;
}

bool TaskCore::cleanup() {
    if (mTaskState != Stopped) return false;
    mTargetState = PreOperational;
    cleaned_up_ = true;
    const Outcome outcome = callHook("cleanup()", Stopped, [this] { return cleanupHook(), true; });
    cleaned_up_ = false;
    if (outcome != Outcome::Accepted) return false;
    setState(PreOperational);
    return true;
}

bool TaskCore::start() {
    if (mTaskState != Stopped) return false;
    mTargetState = Running;
    switch (callHook("start()", Stopped, [this] { return startHook(); })) {
        case Outcome::Accepted:
            ++mStartCounter;
            setState(Running);
            if (mTriggerOnStart) trigger();
            return true;
        case Outcome::Refused:
            if (mTaskState == Stopped) mTargetState = Stopped;
            return false;
        case Outcome::Threw: break;
    }
    return false;
}

bool TaskCore::stop() {
    if (mTaskState < Running) return false;
    mTargetState = Stopped;  // the engine calls no further hook
    if (!ee->stopTask()) {
        log(Error) << getName() << ": stop() failed, because the step that is being executed does not end" << endlog();
        mTargetState = mTaskState.load();
        return false;
    }
    const TaskState from = mTaskState;
    if (from < Running) return false;  // that step ended in Exception or FatalError
    mTargetState = Stopped;            // again: it may have called error() or recover()
    stopped_ = true;
    const Outcome outcome = callHook("stop()", from, [this] { return stopHook(), true; });
    stopped_ = false;
    if (outcome != Outcome::Accepted) return false;
    setState(Stopped);
    return true;
}

bool TaskCore::activate() {
    if (ee->getActivity()) ee->getActivity()->start();
    return isActive();
}

void TaskCore::error() {
    if (mTargetState >= Running) setState(RunTimeError);
}

bool TaskCore::recover() {
    if (mTaskState == Exception)
        setState(mInitialState);
    else if (mTaskState == RunTimeError)
        setState(Running);
    else
        return false;
    return true;
}

void TaskCore::exception() {
    const TaskState from = mTaskState;
    if (from == FatalError) return;
    setState(Exception);
    try {
        // A hook that threw is not called again because of that.
        if (from >= Running && !stopped_) stopHook();
        if (from >= Stopped && mInitialState == PreOperational && !cleaned_up_) cleanupHook();
        exceptionHook();
        return;
    } catch (const std::exception& e) {
        log(Error) << getName() << ": a hook threw while the component entered state Exception: " << e.what()
                   << endlog();
    } catch (...) {
        log(Error) << getName() << ": a hook threw while the component entered state Exception" << endlog();
    }
    fatal();
}

void TaskCore::fatal() {
    setState(FatalError);
    ee->setFatalTask();
}

bool TaskCore::update() { return ee->getActivity() && ee->getActivity()->execute(); }
bool TaskCore::trigger() { return ee->getActivity() && ee->getActivity()->timeout(); }

bool TaskCore::isConfigured() const { return mTaskState >= Stopped; }
bool TaskCore::isRunning() const { return mTaskState >= Running; }
bool TaskCore::isActive() const { return ee->getActivity() && ee->getActivity()->isActive(); }
bool TaskCore::inFatalError() const { return mTaskState == FatalError; }
bool TaskCore::inException() const { return mTaskState == Exception; }
bool TaskCore::inRunTimeError() const { return mTaskState == RunTimeError; }
TaskCore::TaskState TaskCore::getTaskState() const { return mTaskState; }
TaskCore::TaskState TaskCore::getTargetState() const { return mTargetState; }

Seconds TaskCore::getPeriod() const { return ee->getActivity() ? ee->getActivity()->getPeriod() : -1.0; }
bool TaskCore::setPeriod(Seconds period) { return ee->getActivity() && ee->getActivity()->setPeriod(period); }
unsigned TaskCore::getCpuAffinity() const { return ee->getActivity() ? ee->getActivity()->getCpuAffinity() : ~0u; }
bool TaskCore::setCpuAffinity(unsigned cpu) { return ee->getActivity() && ee->getActivity()->setCpuAffinity(cpu); }

bool TaskCore::configureHook() { return true; }
bool TaskCore::startHook() { return true; }
void TaskCore::updateHook() {}
bool TaskCore::breakUpdateHook() { return true; }
void TaskCore::errorHook() {}
void TaskCore::stopHook() {}
void TaskCore::cleanupHook() {}
void TaskCore::exceptionHook() {}
void TaskCore::dataOnPortCallback(PortInterface*) {}

}  // namespace base
}  // namespace RTT
