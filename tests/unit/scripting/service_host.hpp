// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component with the scripting service, and what the log got.
#ifndef OROFORGE_TESTS_SCRIPTING_SERVICE_HOST_HPP
#define OROFORGE_TESTS_SCRIPTING_SERVICE_HOST_HPP

#include <rtt/RTT.hpp>
#include <rtt/scripting/ScriptingService.hpp>
#include <unit/flow/log_capture.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace service_test {

/** Executed by hand, with a period. Scripts change `count` and call note(), fail() and refuse(). */
class Host : public RTT::TaskContext {
public:
    explicit Host(const std::string& name = "host");
    ~Host() override { stop(); }

    /** Steps of the engine. */
    void step(int times = 1);
    /** Into FatalError. */
    void breakDown() { fatal(); }

    int count = 0;
    std::vector<std::string> notes;

private:
    void note(const std::string& text) { notes.push_back(text); }
    int fail();
};

/** Types and services are loaded; the log at level Warning is kept. */
class ServiceTest : public testing::Test {
protected:
    ServiceTest();

    /** What the log said since the last call, without times and modules. */
    std::string logged();
    bool eval(const std::string& code) { return service->eval(code); }

private:
    flow_test::LogCapture log_;
    std::size_t seen_ = 0;

protected:
    Host host;
    RTT::scripting::ScriptingService::shared_ptr service;
};

}  // namespace service_test

#endif
