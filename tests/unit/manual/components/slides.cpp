// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The listings of the introduction's component code, completed to components that can be loaded.
#include <rtt/RTT.hpp>

#include <rtt/Component.hpp>

#include <string>
#include <vector>

namespace slides {

/** Counts from its property, in its own thread also when it is told to count from elsewhere. */
class MyComp : public RTT::TaskContext {
public:
    MyComp(std::string const& name);
    // no configure phase needed here.
    bool startHook();
    void updateHook();
    void stopHook();
    // operation
    void setCounter(int);

private:
    // ports
    RTT::OutputPort<int> outport_counter;
    // properties
    int init_value;
    // other variables
    int current_index;
};

}  // namespace slides

using namespace RTT;

namespace slides {

MyComp::MyComp(std::string const& name) : TaskContext(name), init_value(0), current_index(0) {
    addPort("outport_counter", outport_counter);
    addProperty("init_value", init_value);
    addOperation("setCounter", &MyComp::setCounter, this, OwnThread);
    addAttribute("counter", current_index);
}

bool MyComp::startHook() {
    if (init_value < 0) return false;
    current_index = init_value;
    return true;  // false stops the transition
}

void MyComp::updateHook() {
    current_index++;
    outport_counter.write(current_index);
}

void MyComp::stopHook() { current_index = init_value; }

void MyComp::setCounter(int new_value) { current_index = new_value; }

/** A vector of event ports with one callback, which is told the number of the port. */
class Encoders : public RTT::TaskContext {
public:
    Encoders(std::string const& name);

private:
    void encoder_callback(RTT::base::PortInterface* portInterface, int i);
    void updateHook();

    std::vector<RTT::InputPort<int>> inports;
    std::vector<bool> newDataArrived;
    std::string last_port;
    int complete;
};

Encoders::Encoders(std::string const& name)
    : TaskContext(name, PreOperational), inports(3), newDataArrived(3), complete(0) {
    for (int i = 0; i < 3; i++) {
        addEventPort("encoder_" + std::to_string(i + 1), inports[i],
                     boost::bind(&Encoders::encoder_callback, this, _1, i))
            .doc("Encoder Value of Motor " + std::to_string(i + 1));
    }
    addAttribute("last_port", last_port);
    addAttribute("complete", complete);
}

void Encoders::encoder_callback(RTT::base::PortInterface* portInterface, int i) {
    last_port = portInterface->getName();
    newDataArrived[i] = true;
}

void Encoders::updateHook() {
    if (!(newDataArrived[0] && newDataArrived[1] && newDataArrived[2])) return;
    ++complete;
}

/** What is called: "reset" tells whether it was done. */
class ATask : public RTT::TaskContext {
public:
    ATask(std::string const& name) : TaskContext(name) {
        addOperation("reset", &ATask::reset, this);
        addOperation("ownReset", &ATask::reset, this, OwnThread);
        addAttribute("resets", resets);
    }

private:
    bool reset() { return ++resets > 0; }
    int resets = 0;
};

/** Calls and sends the operation of its peer, and logs. */
class Caller : public RTT::TaskContext {
public:
    Caller(std::string const& name) : TaskContext(name) {
        addOperation("callIt", &Caller::callIt, this, OwnThread);
        addOperation("sendIt", &Caller::sendIt, this, OwnThread);
        addOperation("fail", &Caller::fail, this, OwnThread);
    }

private:
    bool callIt() {
        TaskContext* a_task_ptr = getPeer("ATask");
        OperationCaller<bool(void)> reset_meth = a_task_ptr->getOperation("reset");
        // Call 'reset' of a_task, blocking
        bool ok = reset_meth();
        // One that is executed in the other's thread needs to know who waits.
        OperationCaller<bool(void)> own_reset_meth(a_task_ptr->getOperation("ownReset"), engine());
        return own_reset_meth() && ok;
    }
    bool sendIt() {
        OperationCaller<bool(void)> reset_meth(getPeer("ATask")->getOperation("ownReset"), engine());
        SendHandle<bool(void)> handle = reset_meth.send();
        bool ok = false;
        if (handle.collectIfDone() == SendSuccess) ok = handle.ret();
        handle = reset_meth.send();
        SendStatus ss = handle.collect(ok);
        return ss == SendSuccess && ok;
    }
    void fail() {
        Logger::In in(this->getName());
        RTT::log(Error) << " failed, ...." << RTT::endlog();
    }
};

}  // namespace slides

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(slides::MyComp)
ORO_LIST_COMPONENT_TYPE(slides::Encoders)
ORO_LIST_COMPONENT_TYPE(slides::ATask)
ORO_LIST_COMPONENT_TYPE(slides::Caller)
