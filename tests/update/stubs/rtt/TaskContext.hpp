// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// As much of RTT as the classes of round_trip.py need, so that a case takes no second.
#ifndef OROFORGE_TESTS_UPDATE_STUB_TASK_CONTEXT_HPP
#define OROFORGE_TESTS_UPDATE_STUB_TASK_CONTEXT_HPP

#include <string>

namespace RTT {

enum ExecutionThread { OwnThread, ClientThread };

struct Described {
    Described& doc(const std::string& words);
    Described& arg(const std::string& name, const std::string& words);
};

class TaskContext {
public:
    explicit TaskContext(const std::string& name);
    virtual ~TaskContext();
    virtual bool configure();
    virtual bool stop();
    template <class Port>
    Described& addPort(const std::string& name, Port& port);
    template <class T>
    Described& addProperty(const std::string& name, T& value);
    template <class Method, class Class>
    Described& addOperation(const std::string& name, Method method, Class* object,
                            ExecutionThread thread = ClientThread);

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
