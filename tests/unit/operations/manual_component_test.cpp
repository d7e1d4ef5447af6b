// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The components of the manual, written as their users write them.
#include <rtt/RTT.hpp>

#include "probe.hpp"

#include <rtt/internal/GlobalEngine.hpp>

using namespace RTT;
using oroforge::test::eventually;

namespace {

class MyComp : public RTT::TaskContext {
public:
    MyComp(std::string const& name);
    ~MyComp() { stop(); }
    // bool configureHook(); // no configure phase needed here.
    bool startHook();
    void updateHook();
    void stopHook();
    // operation
    void setCounter(int);
    bool reset(void) { return std::exchange(current_index, 0) != 0; }

private:
    // ports
    RTT::OutputPort<int> outport_counter;
    // properties
    int init_value;
    // other variables
    int current_index = 0;
};

MyComp::MyComp(std::string const& name) : TaskContext(name), init_value(0) {
    addPort("outport_counter", outport_counter);
    addProperty("init_value", init_value);
    addOperation("setCounter", &MyComp::setCounter, this, OwnThread);
    addOperation("reset", &MyComp::reset, this, OwnThread).doc("Back to zero.");
}

bool MyComp::startHook() {
    if (init_value < 0) return false;
    current_index = init_value;
    return true;  // return false will stop the transition
}
void MyComp::updateHook() {
    current_index++;
    outport_counter.write(current_index);
}
void MyComp::stopHook() { current_index = init_value; }
void MyComp::setCounter(int new_value) { current_index = new_value; }

TEST(ManualComponent, CountsFromItsProperty) {
    MyComp c("counter");
    InputPort<int> in("in");
    ASSERT_TRUE(c.getPort("outport_counter")->connectTo(&in));
    Property<int> init = c.getProperty("init_value");
    init = -1;
    EXPECT_FALSE(c.start());
    init.set(41);
    ASSERT_TRUE(c.start());
    int got = 0;
    EXPECT_TRUE(eventually([&] { return in.read(got) == NewData; }));
    EXPECT_EQ(got, 42);
    OperationCaller<void(int)> setCounter(c.getOperation("setCounter"), internal::GlobalEngine::Instance());
    setCounter(7);
    ASSERT_TRUE(c.trigger());
    EXPECT_TRUE(eventually([&] { return in.read(got) == NewData; }));
    EXPECT_EQ(got, 8);
    EXPECT_TRUE(c.stop());
}

/** Waits for one sample of each of three motors. */
class base_interface : public RTT::TaskContext {
public:
    base_interface(std::string const& name)
        : TaskContext(name, PreOperational), newDataArrived(3), XYZ_Motor_encoder_inport(3) {
        for (int i = 0; i < 3; i++) {
            addEventPort("XYZ_Motor_encoder_" + std::to_string(i + 1), XYZ_Motor_encoder_inport[i],
                         boost::bind(&base_interface::encoder_callback, this, _1, i))
                .doc("Encoder Value of Motor " + std::to_string(i + 1));
        }
    }
    ~base_interface() { stop(); }
    std::atomic<int> complete{0};

private:
    void encoder_callback(RTT::base::PortInterface* portInterface, int i) {
        newDataArrived[i] = portInterface == &XYZ_Motor_encoder_inport[i];
    }
    void updateHook() {
        if (!(newDataArrived[0] && newDataArrived[1] && newDataArrived[2])) return;
        newDataArrived.assign(3, false);
        complete++;
    }
    std::vector<bool> newDataArrived;
    std::vector<RTT::InputPort<int>> XYZ_Motor_encoder_inport;
};

TEST(ManualComponent, GetsAllEncodersBetweenItsPeriods) {
    base_interface c("base");
    EXPECT_EQ(c.ports()->getPortDescription("XYZ_Motor_encoder_2"), "Encoder Value of Motor 2");
    OutputPort<int> motors[3];
    for (int i = 0; i < 3; i++)
        ASSERT_TRUE(motors[i].connectTo(c.getPort("XYZ_Motor_encoder_" + std::to_string(i + 1))));
    EXPECT_FALSE(c.start()) << "not configured";
    ASSERT_TRUE(c.configure());
    ASSERT_TRUE(c.setPeriod(0.002));
    ASSERT_TRUE(c.start());
    motors[0].write(1);
    motors[2].write(3);
    usleep(10000);
    EXPECT_EQ(c.complete, 0);
    motors[1].write(2);
    EXPECT_TRUE(eventually([&] { return c.complete == 1; }));
}

/** Calls its peer in one way or another. */
class Caller : public RTT::TaskContext {
public:
    Caller() : TaskContext("Caller") {}
    ~Caller() { stop(); }
    std::atomic<int> result{-1};
    bool sends = false;

private:
    void updateHook() {
        TaskContext* a_task_ptr = getPeer("ATask");
        OperationCaller<bool(void)> my_reset_meth = a_task_ptr->getOperation("reset");
        my_reset_meth.setCaller(engine());
        result = sends ? sent(my_reset_meth) : my_reset_meth();
    }
    bool sent(OperationCaller<bool(void)>& my_reset_meth) {
        SendHandle<bool(void)> handle = my_reset_meth.send();
        bool ok = false;
        if (handle.collectIfDone() == SendSuccess) {
            handle = my_reset_meth.send();
            SendStatus ss = handle.collect();
            if (ss != SendSuccess) {
                std::cout << "Execution of reset failed." << std::endl;
            }
        }
        EXPECT_EQ(handle.collect(ok), SendSuccess);
        return ok;
    }
};

TEST(ManualComponent, IsResetByItsPeer) {
    MyComp task("ATask");
    Caller caller;
    ASSERT_TRUE(connectPeers(&task, &caller));
    OperationCaller<void(int)>(task.getOperation("setCounter"), internal::GlobalEngine::Instance())(5);
    ASSERT_TRUE(caller.start());
    EXPECT_TRUE(eventually([&] { return caller.result == 1; })) << "it was not zero";
    ASSERT_TRUE(caller.stop());
    caller.result = -1;
    caller.sends = true;
    ASSERT_TRUE(caller.start());
    EXPECT_TRUE(eventually([&] { return caller.result == 0; }));
}

}  // namespace
