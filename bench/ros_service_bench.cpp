// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Calls of std_srvs/SetBool within a process, through TCP: callers and operations, against clients and servers of roscpp.
#include "service_fixture.hpp"

#include <rtt/internal/GlobalEngine.hpp>

#include <benchmark/benchmark.h>
#include <ros/ros.h>

using namespace service_test;

namespace {

bool answer(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
    response.success = request.data;
    response.message = "answered";
    return true;
}

/** The services /roscpp, /client and /own, whose operations execute in a spinner and in the component. */
struct World {
    World() {
        loadServices();
        master();
        pump = std::make_unique<Pump>("pump");
        pump->start();
        pump->services = pump->getProvider<rtt_roscomm::ROSService>("rosservice");
        server = ros::NodeHandle().advertiseService("/roscpp", &answer);
        if (!pump->services->connect("client", "/client", "std_srvs/SetBool") ||
            !pump->services->connect("own.standard", "/own", "std_srvs/SetBool") ||
            !pump->services->connect("away.standard", "/roscpp", "std_srvs/SetBool") ||
            !pump->services->connect("withMessage", "/roscpp", "std_srvs/SetBool"))
            throw std::runtime_error("no services");
    }
    std::unique_ptr<Pump> pump;
    ros::ServiceServer server;
};

Pump& pump() {
    master();
    static World world;
    return *world.pump;
}

void roscppCalls(benchmark::State& state, const std::string& service, bool isPersistent) {
    pump();
    ros::ServiceClient client = ros::NodeHandle().serviceClient<std_srvs::SetBool>(service, isPersistent);
    std_srvs::SetBool call;
    call.request.data = true;
    for (auto _ : state)
        if (!client.call(call)) state.SkipWithError("the call failed");
}

void callerCalls(benchmark::State& state) {
    Pump& component = pump();
    std_srvs::SetBool call;
    call.request.data = true;
    for (auto _ : state)
        if (!component.standard(call.request, call.response)) state.SkipWithError("the call failed");
}

void sentCalls(benchmark::State& state) {
    Pump& component = pump();
    std_srvs::SetBool call;
    call.request.data = true;
    for (auto _ : state)
        if (component.standard.send(call.request, call.response).collect() != RTT::SendSuccess)
            state.SkipWithError("the call failed");
}

BENCHMARK_CAPTURE(roscppCalls, roscpp_to_roscpp, "/roscpp", true)->UseRealTime();
BENCHMARK_CAPTURE(roscppCalls, roscpp_to_roscpp_not_persistent, "/roscpp", false)->UseRealTime();
BENCHMARK_CAPTURE(roscppCalls, roscpp_to_operation_in_client_thread, "/client", true)->UseRealTime();
BENCHMARK_CAPTURE(roscppCalls, roscpp_to_operation_in_own_thread, "/own", true)->UseRealTime();
BENCHMARK(callerCalls)->Name("caller_to_roscpp")->UseRealTime();
BENCHMARK(sentCalls)->Name("sent_to_roscpp")->UseRealTime();

}  // namespace
