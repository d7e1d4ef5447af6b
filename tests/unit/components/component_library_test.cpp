// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// HelloWorld, the timer, the console output, and the library as the deployer imports it.
#include "library_fixture.hpp"

#include <ocl/HMIConsoleOutput.hpp>
#include <ocl/HelloWorld.hpp>
#include <ocl/TimerComponent.hpp>
#include <rtt/Activity.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/os/TimeService.hpp>

#include <chrono>
#include <future>

namespace {

using namespace components_test;

class HelloWorld : public WithLibrary {
protected:
    HelloWorld() { hello.setActivity(new RTT::extras::SlaveActivity(0.1)); }
    OCL::HelloWorld hello{"hello"};
};

TEST_F(HelloWorld, HasTenCyclesPerSecond) {
    const OCL::HelloWorld fresh("fresh");
    EXPECT_DOUBLE_EQ(0.1, fresh.getPeriod());
    EXPECT_FALSE(fresh.isConfigured());
}

TEST_F(HelloWorld, WritesAndKeepsItsGreeting) {
    ASSERT_TRUE(hello.configure());
    ASSERT_TRUE(hello.start());
    hello.update();
    RTT::InputPort<std::string> in;
    ASSERT_TRUE(in.connectTo(hello.getPort("the_results"), RTT::ConnPolicy::data()));
    std::string text;
    EXPECT_EQ(RTT::NewData, in.read(text));
    EXPECT_EQ("Hello World!", text);
}

TEST_F(HelloWorld, ShowsItsValuesWhenTheFlagIsSet) {
    ASSERT_TRUE(hello.configure());
    ASSERT_TRUE(hello.start());
    RTT::Attribute<bool> flag(hello.getAttribute("flag"));
    flag.set(true);
    testing::internal::CaptureStdout();
    hello.update();
    hello.update();
    EXPECT_EQ(
        "flag: 1\n"
        "the_property: Hello Property\n"
        "the_attribute: Hello Attribute\n"
        "the_constant: Hello Constant\n"
        "Setting 'flag' back to false.\n",
        testing::internal::GetCapturedStdout());
    EXPECT_FALSE(flag.get());
}

TEST_F(HelloWorld, OperationsSayHello) {
    RTT::OperationCaller<std::string()> method(hello.getOperation("the_method"));
    EXPECT_EQ("Hello World", method());
    OCL::HelloWorld own("own");  // with its thread
    RTT::OperationCaller<bool(std::string)> command(own.getOperation("the_command"), hello.engine());
    testing::internal::CaptureStdout();
    const bool world = command("World"), moon = command("Moon");
    EXPECT_EQ("Saying Hello 'World' in own thread.\nSaying Hello 'Moon' in own thread.\n",
              testing::internal::GetCapturedStdout());
    EXPECT_TRUE(world);
    EXPECT_FALSE(moon);
}

TEST_F(HelloWorld, EmptiesItsBufferPort) {
    RTT::OutputPort<std::string> out("out");
    ASSERT_TRUE(out.connectTo(hello.getPort("the_buffer_port")));
    auto* const in = dynamic_cast<RTT::InputPort<std::string>*>(hello.getPort("the_buffer_port"));
    EXPECT_EQ(13, in->getDefaultPolicy().size);
    EXPECT_EQ(RTT::ConnPolicy::BUFFER, in->getDefaultPolicy().type);
    ASSERT_TRUE(hello.configure());
    ASSERT_TRUE(hello.start());
    for (int i = 0; i < 13; ++i) EXPECT_EQ(RTT::WriteSuccess, out.write("text"));
    EXPECT_EQ(RTT::WriteFailure, out.write("text"));
    hello.update();
    std::string text;
    EXPECT_NE(RTT::NewData, in->read(text));
}

class Timers : public WithLibrary {
protected:
    Timers() {
        for (const char* name : {"timeout", "timer_3"}) {
            auto& port = std::string(name) == "timeout" ? any : third;
            EXPECT_TRUE(port.connectTo(timer.getPort(name), RTT::ConnPolicy::buffer(100)));
        }
    }
    template <class S>
    RTT::OperationCaller<S> operation(const std::string& name) {
        return RTT::OperationCaller<S>(timer.getOperation(name));
    }
    /** All that is in the port. */
    static std::vector<int> all(RTT::InputPort<int>& port) {
        std::vector<int> ids;
        for (int id = 0; port.read(id) == RTT::NewData;) ids.push_back(id);
        return ids;
    }

    OCL::TimerComponent timer{"timer"};
    RTT::InputPort<int> any, third;
};

TEST_F(Timers, ExpireToTheirPorts) {
    ASSERT_TRUE(timer.configure());
    ASSERT_TRUE(timer.start());
    EXPECT_TRUE(operation<bool(int, double)>("wait")(3, 0.01));
    EXPECT_TRUE(operation<bool(int, double)>("wait")(31, 0.01));
    EXPECT_FALSE(operation<bool(int, double)>("arm")(32, 0.01));
    timer.stop();
    EXPECT_EQ((std::vector<int>{3, 31}), all(any));
    EXPECT_EQ(std::vector<int>{3}, all(third));
}

TEST_F(Timers, RunOnlyBetweenStartAndStop) {
    ASSERT_TRUE(timer.configure());
    EXPECT_TRUE(operation<bool(int, double)>("arm")(3, 0.0));
    EXPECT_TRUE(operation<bool(int)>("isArmed")(3));
    EXPECT_TRUE(all(any).empty());
    ASSERT_TRUE(timer.start());
    operation<bool(int)>("waitFor")(3);
    timer.stop();
    EXPECT_FALSE(operation<bool(int)>("isArmed")(3));
    EXPECT_EQ(std::vector<int>{3}, all(third));
}

TEST_F(Timers, RepeatUntilTheyAreKilled) {
    ASSERT_TRUE(timer.configure());
    ASSERT_TRUE(timer.start());
    EXPECT_TRUE(operation<bool(int, double)>("startTimer")(3, 0.002));
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(operation<bool(int)>("waitFor")(3));
    EXPECT_TRUE(operation<bool(int)>("killTimer")(3));
    EXPECT_FALSE(operation<bool(int)>("waitFor")(3));
    timer.stop();
    EXPECT_GE(all(third).size(), 3u);
}

TEST_F(Timers, WaitLastsAsLongInAComponentThatDoesNotRun) {
    const RTT::Seconds begin = RTT::os::TimeService::Instance()->getSeconds();
    EXPECT_TRUE(operation<bool(int, double)>("wait")(3, 0.05));
    EXPECT_GE(RTT::os::TimeService::Instance()->getSeconds() - begin, 0.05);
    EXPECT_TRUE(operation<bool(int, double)>("wait")(3, 0.0));
    EXPECT_TRUE(all(any).empty()) << "nothing expires";
    EXPECT_FALSE(operation<bool(int, double)>("wait")(32, 0.0)) << "no such timer";
    EXPECT_FALSE(operation<bool(int, double)>("wait")(3, -1.0));
    EXPECT_FALSE(operation<bool(int, double)>("wait")(3, 1e300));
}

TEST_F(Timers, WaitForLastsAsLongInAComponentThatDoesNotRun) {
    EXPECT_FALSE(operation<bool(int)>("waitFor")(3)) << "not armed";
    const RTT::Seconds begin = RTT::os::TimeService::Instance()->getSeconds();
    EXPECT_TRUE(operation<bool(int, double)>("arm")(3, 0.05));
    EXPECT_TRUE(operation<bool(int)>("waitFor")(3));
    EXPECT_GE(RTT::os::TimeService::Instance()->getSeconds() - begin, 0.05);
    EXPECT_TRUE(operation<bool(int)>("waitFor")(3)) << "its time has come already";

    ASSERT_TRUE(timer.configure());
    EXPECT_TRUE(operation<bool(int, double)>("arm")(4, 1000.0));
    auto killed = std::async(std::launch::async, [&] { return operation<bool(int)>("waitFor")(4); });
    auto expired = std::async(std::launch::async, [&] { return operation<bool(int, double)>("wait")(5, 0.3); });
    EXPECT_EQ(std::future_status::timeout, killed.wait_for(std::chrono::milliseconds(20)));
    ASSERT_TRUE(timer.start());
    EXPECT_TRUE(operation<bool(int)>("killTimer")(4));
    EXPECT_TRUE(killed.get());
    EXPECT_TRUE(expired.get());
    EXPECT_FALSE(operation<bool(int, double)>("wait")(3, 1e300)) << "too long";
}

TEST_F(Timers, StopEndsWaits) {
    ASSERT_TRUE(timer.configure());
    ASSERT_TRUE(timer.start());
    EXPECT_TRUE(operation<bool(int, double)>("arm")(4, 1000.0));
    std::future<bool> waits[] = {
        std::async(std::launch::async, [this] { return operation<bool(int, double)>("wait")(3, 1000.0); }),
        std::async(std::launch::async, [this] { return operation<bool(int)>("waitFor")(4); })};
    for (std::future<bool>& wait : waits)
        EXPECT_EQ(std::future_status::timeout, wait.wait_for(std::chrono::milliseconds(50)));
    timer.stop();
    for (std::future<bool>& wait : waits) EXPECT_FALSE(wait.get());
    EXPECT_TRUE(operation<bool(int)>("isArmed")(4));
    // Killing ends them as before.
    ASSERT_TRUE(timer.start());
    std::promise<void> waiting;
    std::future<bool> killed = std::async(std::launch::async, [this, &waiting] {
        waiting.set_value();
        return operation<bool(int)>("waitFor")(4);
    });
    waiting.get_future().wait();
    EXPECT_EQ(std::future_status::timeout, killed.wait_for(std::chrono::milliseconds(50)));
    EXPECT_TRUE(operation<bool(int)>("killTimer")(4));
    EXPECT_TRUE(killed.get());
    timer.stop();
}

TEST_F(Timers, MoreThanThirtyTwoUseTheCommonPort) {
    operation<void(int)>("setMaxTimers")(40);
    ASSERT_TRUE(timer.configure());
    ASSERT_TRUE(timer.start());
    EXPECT_TRUE(operation<bool(int, double)>("wait")(39, 0.001));
    timer.stop();
    EXPECT_EQ(std::vector<int>{39}, all(any));
}

class ConsoleOutput : public WithLibrary {
protected:
    ConsoleOutput() {
        cout.setActivity(new RTT::extras::SlaveActivity());
        cout.enableColor(false);
    }
    std::string shown() {
        testing::internal::CaptureStdout();
        cout.update();
        return testing::internal::GetCapturedStdout();
    }
    OCL::HMIConsoleOutput cout;
};

TEST_F(ConsoleOutput, ShowsWhatWasDisplayedInTheNextCycle) {
    EXPECT_EQ("cout", cout.getName());
    ASSERT_TRUE(cout.start());
    RTT::OperationCaller<void(std::string)>(cout.getOperation("display"))("hello");
    RTT::OperationCaller<void(bool)>(cout.getOperation("displayBool"))(true);
    RTT::OperationCaller<void(int)>(cout.getOperation("displayInt"))(-4);
    RTT::OperationCaller<void(double)>(cout.getOperation("displayDouble"))(0.25);
    cout.enqueue("from C++");
    EXPECT_EQ("HMIConsoleOutput :\nhello\n1\n-4\n0.25\nfrom C++\n\n", shown());
    EXPECT_EQ("", shown());
}

TEST_F(ConsoleOutput, PromptAndColourCanBeChosen) {
    ASSERT_TRUE(cout.start());
    cout.setPrompt("> ");
    cout.enableColor(true);
    cout.display("blue");
    EXPECT_EQ("\033[1;34m> \033[0mblue\n\n", shown());
}

TEST_F(ConsoleOutput, LogsAtLevelInfo) {
    std::ostringstream log;
    RTT::Logger::Instance()->setStdStream(log);
    const auto level = RTT::Logger::Instance()->getLogLevel();
    RTT::Logger::Instance()->setLogLevel(RTT::Info);
    cout.log("hello");
    cout.logBool(false);
    cout.logInt(7);
    cout.logDouble(1.5);
    RTT::Logger::Instance()->setLogLevel(level);
    RTT::Logger::Instance()->setStdStream(std::cerr);
    for (const char* line : {"] hello\n", "] 0\n", "] 7\n", "] 1.5\n"})
        EXPECT_THAT(log.str(), testing::HasSubstr(line));
    EXPECT_THAT(log.str(), testing::HasSubstr("Info"));
}

TEST_F(WithLibrary, ImportBringsTheTypesOfTheComponentLibrary) {
    for (const char* type : {"TaskContext", "OCL::ConsoleReporting", "OCL::FileReporting", "OCL::HMIConsoleOutput",
                             "OCL::HelloWorld", "OCL::TimerComponent"})
        EXPECT_TRUE(deployer().loadComponent(std::string("a ") + type, type)) << type;
    EXPECT_TRUE(deployer().loadComponent(
        "by file", OCL_TEST_PATH "/" OROCOS_TARGET_NAME "/ocl/liborocos-ocl-helloworld-" OROCOS_TARGET_NAME ".so"));
    for (const std::string& name : deployer().getPeerList()) EXPECT_TRUE(deployer().unloadComponent(name)) << name;
}

}  // namespace
