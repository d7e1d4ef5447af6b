// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component of another process, and its proxy.
#ifndef OROFORGE_TESTS_CORBA_PEER_FIXTURE_HPP
#define OROFORGE_TESTS_CORBA_PEER_FIXTURE_HPP

#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/transports/corba/TaskContextProxy.hpp>
#include <rtt/transports/corba/TaskContextServer.hpp>
#include <rtt/types/Types.hpp>

#include <gtest/gtest.h>
#include <support/child_process.hpp>
#include <support/temp_dir.hpp>
#include <unit/transports/transport_fixture.hpp>

#include <chrono>
#include <csignal>
#include <memory>
#include <string>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

namespace corba_test {

using transport_test::soon;

class PeerFixture : public testing::Test {
protected:
    static void SetUpTestSuite() {
        if (!RTT::types::Types()->type("double")) {
            ASSERT_TRUE(RTT::plugin::PluginLoader::Instance()->loadTypekit("rtt-typekit"));
        }
        int argc = 1;
        char name[] = "test";
        char* argv[] = {name, nullptr};
        ASSERT_TRUE(RTT::corba::TaskContextServer::InitOrb(argc, argv));
    }
    static void TearDownTestSuite() { RTT::corba::TaskContextServer::DestroyOrb(); }

    void SetUp() override {
        begin();
        peer.reset(RTT::corba::TaskContextProxy::CreateFromFile((directory.path() / "peer.ior").string()));
        ASSERT_TRUE(peer);
    }
    /** Starts the other process. */
    void begin() {
        oroforge::test::Command command;
        command.program = CORBA_PEER;
        command.directory = directory.path();
        command.environment["ORO_LOGFILE"] = "/dev/null";
        command.environment["ORBclientCallTimeOutPeriod"] = "30000";  // ms, for each call of the other process
        child = std::make_unique<oroforge::test::ChildProcess>(command);
        ASSERT_TRUE(child->waitForOutput("reference IOR:", std::chrono::seconds(20)));
    }
    void TearDown() override {
        peer.reset();
        child.reset();
    }
    void end(int signal) {
        child->send(signal);
        (void)child->finish();
    }
    /** Afterwards none of its threads executes. */
    void suspend() {
        child->send(SIGSTOP);
        siginfo_t info{};
        ASSERT_EQ(waitid(P_PID, static_cast<id_t>(child->pid()), &info, WSTOPPED | WNOWAIT), 0);
    }
    oroforge::test::TempDir directory;
    std::unique_ptr<oroforge::test::ChildProcess> child;
    std::unique_ptr<RTT::corba::TaskContextProxy> peer;
};

}  // namespace corba_test

#endif
