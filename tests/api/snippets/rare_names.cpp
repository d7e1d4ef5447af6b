// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Names of which there are few users each: of the system layer, of states, of visitors of bags.
#include <rtt/RTT.hpp>
#include <rtt/extras/TimerThread.hpp>
#include <rtt/internal/carray.hpp>
#include <rtt/marsh/PropertyBagIntrospector.hpp>
#include <rtt/os/fosi.h>
#include <rtt/os/tlsf/tlsf.h>

#include <gtest/gtest.h>

#include <cstring>

using namespace RTT;

namespace {

RTT_UNUSED void nobodyCallsIt() {}

class Stepper : public TaskContext {
public:
    Stepper() : TaskContext("stepper", PreOperational) {}
    bool configureHook() override {
        during = mTaskState;
        aimed_at = mTargetState;
        return true;
    }
    bool running() const { return mTaskState == Running; }
    const char* name() const {
        switch (mTaskState) {
            case PreOperational: return "pre-operational";
            case Stopped: return "stopped";
            default: return "other";
        }
    }
    void fall() { mTaskState = RunTimeError; }
    TaskState during = Init, aimed_at = Init;
};

}  // namespace

TEST(RareNames, SubclassesReadTheStateAsAVariable) {
    Stepper stepper;
    EXPECT_STREQ("pre-operational", stepper.name());
    ASSERT_TRUE(stepper.configure());
    EXPECT_EQ(TaskContext::PreOperational, stepper.during);
    EXPECT_EQ(TaskContext::Stopped, stepper.aimed_at);
    EXPECT_STREQ("stopped", stepper.name());
    EXPECT_FALSE(stepper.running());
    ASSERT_TRUE(stepper.start());
    EXPECT_TRUE(stepper.running());
    EXPECT_TRUE(stepper.stop());
}

TEST(RareNames, SubclassesSetTheStateAsAVariable) {
    Stepper stepper;
    ASSERT_TRUE(stepper.configure() && stepper.start());
    stepper.fall();
    EXPECT_TRUE(stepper.inRunTimeError());
    EXPECT_EQ(TaskContext::RunTimeError, stepper.getTargetState());
    EXPECT_TRUE(stepper.recover());
    EXPECT_TRUE(stepper.stop());
}

TEST(RareNames, NanosleepWaits) {
    const TIME_SPEC little = ticks2timespec(2000000);
    const NANO_TIME before = rtos_get_time_ns();
    EXPECT_EQ(0, rtos_nanosleep(&little, nullptr));
    EXPECT_GE(rtos_get_time_ns() - before, 2000000);
    TIME_SPEC never = {0, 0}, rest = {0, 0};
    never.tv_nsec = -1;
    EXPECT_EQ(-1, rtos_nanosleep(&never, &rest));
}

TEST(RareNames, RealTimeMemoryComesFromTheHeaderOfItsPools) {
    void* const block = oro_rt_malloc(64);
    ASSERT_NE(nullptr, block);
    std::memset(block, 1, 64);
    oro_rt_free(block);
    EXPECT_EQ(64u, extras::TimerThread::MAX_ACTIVITIES);
}

TEST(RareNames, AnIntrospectorCollectsABagWithWhatIsInItsValues) {
    PropertyBag source;
    double speed = 2;
    source.addProperty("speed", speed);
    Property<PropertyBag> inner("inner", "nested");
    int number = 3;
    inner.value().addProperty("number", number);
    source.addProperty(inner);
    PropertyBag target;
    marsh::PropertyBagIntrospector collector(target);
    source.identify(&collector);
    ASSERT_EQ(2u, target.size());
    Property<double> found = target.getProperty("speed");
    ASSERT_TRUE(found.ready());
    EXPECT_EQ(2, found.get());
    Property<PropertyBag> nested = target.getProperty("inner");
    ASSERT_TRUE(nested.ready());
    EXPECT_NE(nullptr, nested.rvalue().getProperty("number"));
}

TEST(RareNames, ViewsOnArraysHaveTheirOldPlace) {
    double numbers[3] = {1, 2, 3};
    internal::carray<double> view(numbers);
    EXPECT_EQ(3u, view.count());
    EXPECT_EQ(2, view[1]);
}

TEST(RareNames, ThePeersOfAPortAreKnownFromTheUmbrella) {
    OutputPort<int> writer("writer");
    InputPort<int> reader("reader");
    ASSERT_TRUE(writer.connectTo(&reader));
    const internal::ConnectionManager::Connections all = writer.getManager()->getConnections();
    ASSERT_EQ(1u, all.size());
    const internal::ConnectionManager::ChannelDescriptor& only = all.front();
    EXPECT_TRUE(only.get<1>());
    EXPECT_EQ(ConnPolicy::DATA, only.get<2>().type);
}
