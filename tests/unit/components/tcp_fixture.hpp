// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A TcpReporting in its own thread or stepped by the test, and clients of it.
#ifndef OROFORGE_TESTS_COMPONENTS_TCP_FIXTURE_HPP
#define OROFORGE_TESTS_COMPONENTS_TCP_FIXTURE_HPP

#include "reporter_fixture.hpp"
#include "tcp_peer.hpp"

#include <ocl/TcpReporting.hpp>
#include <rtt/Activity.hpp>
#include <rtt/Attribute.hpp>

#include <chrono>
#include <functional>
#include <memory>
#include <thread>

namespace components_test {

class TcpReports : public types_test::WithBuiltinTypes {
protected:
    static void SetUpTestSuite() {
        types_test::WithBuiltinTypes::SetUpTestSuite();
        sample::addTypes();
    }
    void SetUp() override {
        reporter = std::make_unique<OCL::TcpReporting>("Reporter");
        reporter->addPeer(&machine);
        property<unsigned int>("port") = 0;
        property<bool>("Snapshot") = true;
        reporter->setActivity(new RTT::extras::SequentialActivity());
    }

    template <class T>
    T& property(const std::string& name) {
        return dynamic_cast<RTT::Property<T>&>(*reporter->getProperty(name)).value();
    }
    unsigned int count(const std::string& name) {
        return RTT::Attribute<unsigned int>(reporter->getAttribute(name)).get();
    }
    unsigned int port() { return count("used_port"); }
    void row() { reporter->snapshot(); }
    /** Updates the reporter until that is so, for ten seconds at most. */
    bool updateUntil(const std::function<bool()>& condition) {
        for (int i = 0; i < 10000; ++i) {
            if (condition()) return true;
            (void)reporter->trigger();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return false;
    }
    bool hasClients(unsigned int wanted) {
        return updateUntil([this, wanted] { return count("clients") == wanted; });
    }

    Machine machine;
    std::unique_ptr<OCL::TcpReporting> reporter;
};

}  // namespace components_test

#endif
