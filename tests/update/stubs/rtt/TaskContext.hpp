// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// As much of RTT as the classes of round_trip.py need, so that a case takes no second.
#ifndef OROFORGE_TESTS_UPDATE_STUB_TASK_CONTEXT_HPP
#define OROFORGE_TESTS_UPDATE_STUB_TASK_CONTEXT_HPP

#include <string>

namespace RTT {

class TaskContext {
public:
    explicit TaskContext(const std::string& name);
    virtual ~TaskContext();
    virtual bool configure();
    virtual bool stop();

protected:
    virtual bool configureHook();
    virtual bool startHook();
    virtual void updateHook();
    virtual void errorHook();
    virtual void exceptionHook();
    virtual void stopHook();
    virtual void cleanupHook();
};

}  // namespace RTT

#endif
