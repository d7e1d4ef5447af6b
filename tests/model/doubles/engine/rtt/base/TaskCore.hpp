// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In place of the runtime's header: a component of which only the state matters to its engine.
#ifndef OROFORGE_MODEL_TASK_CORE_HPP
#define OROFORGE_MODEL_TASK_CORE_HPP

#include <atomic>
#include <cstdint>
#include <string>

namespace RTT {
namespace base {
class PortInterface;

class TaskCore {
public:
    enum TaskState { Running, RunTimeError, Exception, FatalError };
    bool inFatalError() const { return fatal.load(); }
    bool inException() const { return false; }
    const std::string& getName() const { return name; }
    TaskState getTaskState() const { return Running; }
    TaskState getTargetState() const { return Running; }
    struct States {
        TaskState state, target;
    };
    States states() const { return {Running, Running}; }
    void exception() {}
    void updateHook() {}
    void errorHook() {}
    bool breakUpdateHook() { return true; }
    void (*port_step_)(TaskCore&, PortInterface*) = nullptr;

    std::atomic<bool> fatal{false};  // sequentially consistent, as the state of the real one is
    std::string name = "component";
    unsigned mCycleCounter = 0, mTriggerCounter = 0, mTimeOutCounter = 0, mIOCounter = 0;
};

}  // namespace base
}  // namespace RTT
#endif
