// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Components of the library are unloaded while other threads send to them.
#include "library_fixture.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/internal/GlobalEngine.hpp>

#include <atomic>
#include <thread>
#include <unistd.h>

namespace {

using namespace components_test;

struct Victim {
    const char* type;
    const char* operation;
};

class Unloading : public WithLibrary, public testing::WithParamInterface<Victim> {};

TEST_P(Unloading, WhileTwoThreadsSend) {
    RTT::Logger::Instance()->setLogLevel(RTT::Logger::Never);
    ASSERT_TRUE(deployer().import("ocl"));
    for (int round = 0; round != 60; ++round) {
        ASSERT_TRUE(deployer().loadComponent("victim", GetParam().type));
        RTT::TaskContext* const victim = deployer().getPeer("victim");
        RTT::OperationCaller<void(const std::string&)> tell;
        RTT::OperationCaller<bool(const std::string&)> ask;
        RTT::OperationInterfacePart* const part = victim->getOperation(GetParam().operation);
        const bool isTold = part->resultType() == "void";
        if (isTold)
            tell = part->getLocalOperation();
        else
            ask = part->getLocalOperation();
        tell.setCaller(RTT::internal::GlobalEngine::Instance());
        ask.setCaller(RTT::internal::GlobalEngine::Instance());
        std::atomic<bool> over{false};
        std::atomic<int> begun{0};
        const auto send = [&] {
            const std::string text(100, 'x');
            ++begun;
            while (!over) {
                if (isTold)
                    tell.send(text);
                else
                    ask.send(text);
                usleep(1);
            }
        };
        std::thread one(send), two(send);
        while (begun != 2) usleep(1);
        usleep(50);
        EXPECT_TRUE(deployer().unloadComponent("victim"));
        over = true;
        one.join();
        two.join();
    }
    RTT::Logger::Instance()->setLogLevel(RTT::Logger::Warning);
}

INSTANTIATE_TEST_SUITE_P(Of, Unloading,
                         testing::Values(Victim{"OCL::HMIConsoleOutput", "display"},
                                         Victim{"OCL::HMIConsoleOutput", "log"},
                                         Victim{"OCL::FileReporting", "reportComponent"}),
                         [](const auto& info) {
                             return std::string(info.param.type).substr(5) + "_" + info.param.operation;
                         });

}  // namespace
