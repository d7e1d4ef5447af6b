// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The plugins: the service `ros.clock` of the process and the service `sim_clock_activity` of a component.
#include "clock_test.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/plugin/PluginLoader.hpp>

namespace {

using namespace oroforge::test;
using RTT::Service;

struct Plugins : testing::Test {
    Plugins() {
        const auto loader = RTT::plugin::PluginLoader::Instance();
        loader->setPluginPath(PLUGIN_PATH);
        EXPECT_TRUE(loader->loadPlugin("rtt_rosclock"));
        const Service::shared_ptr ros = RTT::internal::GlobalService::Instance()->getService("ros");
        if (ros) clock = ros->getService("clock");
    }
    template <class Result, class... Arguments>
    Result call(const std::string& name, Arguments... arguments) {
        RTT::OperationCaller<Result(Arguments...)> caller(clock->getOperation(name),
                                                          RTT::internal::GlobalEngine::Instance());
        EXPECT_TRUE(caller.ready()) << name;
        return caller(arguments...);
    }
    Service::shared_ptr clock;
};

TEST_F(Plugins, TheProcessHasItsClock) {
    ASSERT_TRUE(clock);
    EXPECT_NEAR(call<ros::Time>("host_now").toSec(), ros::WallTime::now().toSec(), 5);
    EXPECT_NEAR(call<ros::Time>("host_wall_now").toSec(), ros::WallTime::now().toSec(), 5);
    EXPECT_NEAR(call<ros::Time>("rtt_now").toSec(), static_cast<double>(rtos_get_time_ns()) / 1e9, 5);
    EXPECT_TRUE(call<bool>("useROSClockTopic"));
    EXPECT_FALSE(call<bool>("enableSim"));
    EXPECT_TRUE(call<bool>("useManualClock"));
    EXPECT_EQ(call<int>("catchUpLimit"), 1000);
    EXPECT_FALSE(call<bool>("setCatchUpLimit", -1));
    EXPECT_TRUE(call<bool>("setCatchUpLimit", 50));
    EXPECT_EQ(call<int>("catchUpLimit"), 50);
    for (const std::string suffix : {"", "Clock"}) {
        EXPECT_TRUE(call<bool>("enableSim" + suffix));
        EXPECT_TRUE(call<bool>("updateSimClock", ros::Time(3)));
        EXPECT_EQ(call<ros::Time>("host_now"), ros::Time(3));
        EXPECT_NEAR(call<ros::Time>("host_wall_now").toSec(), ros::WallTime::now().toSec(), 5);
        EXPECT_NEAR(call<ros::Time>("rtt_wall_now").toSec(), static_cast<double>(rtos_get_time_ns()) / 1e9, 5);
        EXPECT_GT(call<double>("host_offset_from_rtt"), 1e6);
        EXPECT_TRUE(call<bool>("disableSim" + suffix));
    }
    EXPECT_FALSE(call<bool>("updateSimClock", ros::Time(4)));
}

TEST_F(Plugins, AComponentExecutesInSimulatedTime) {
    RTT::TaskContext byService("byService"), byOperation("byOperation"), running("running");
    byService.setPeriod(0.5);
    EXPECT_TRUE(byService.loadService("sim_clock_activity"));
    EXPECT_TRUE(byService.loadService("sim_clock_activity"));
    EXPECT_TRUE(byService.provides()->hasService("sim_clock_activity"));
    EXPECT_TRUE(dynamic_cast<rtt_rosclock::SimClockActivity*>(byService.getActivity()));
    EXPECT_EQ(byService.getPeriod(), 0.5);
    EXPECT_TRUE((call<bool, RTT::TaskContext*>("setSimClockActivity", &byOperation)));
    EXPECT_TRUE(dynamic_cast<rtt_rosclock::SimClockActivity*>(byOperation.getActivity()));
    ASSERT_TRUE(running.start());
    EXPECT_FALSE(running.loadService("sim_clock_activity"));
    EXPECT_FALSE(running.provides()->hasService("sim_clock_activity"));
}

}  // namespace
