// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A reporter that the test steps itself, and a component whose values it reports. The clock stands still.
#ifndef OROFORGE_TESTS_COMPONENTS_REPORTER_FIXTURE_HPP
#define OROFORGE_TESTS_COMPONENTS_REPORTER_FIXTURE_HPP

#include <ocl/ConsoleReporting.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/Logger.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/Property.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <types/builtin_typekit.hpp>
#include <types/sample_types.hpp>

#include <gmock/gmock.h>

#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace components_test {

using testing::HasSubstr;

/** What the log says meanwhile. */
class LogText {
public:
    LogText() { RTT::Logger::Instance()->setStdStream(text_); }
    ~LogText() { RTT::Logger::Instance()->setStdStream(std::cerr); }
    std::string operator()() const { return text_.str(); }

private:
    std::ostringstream text_;
};

class Machine : public RTT::TaskContext {
public:
    Machine() : RTT::TaskContext("Machine") {
        addPort("speed", speed);
        addPort("place", place);
        addPort("levels", levels);
        addPort("tank", tank);
        addPort("setpoint", setpoint);
        addPort("mode", mode);
        addProperty("gain", gain);
        addProperty("limits", limits);
        addAttribute("label", label);
        provides("motor")->addPort("current", current);
    }

    RTT::OutputPort<double> speed{"speed"};
    RTT::OutputPort<sample::Point> place{"place"};
    RTT::OutputPort<std::vector<double>> levels{"levels"};
    RTT::OutputPort<sample::Tank> tank{"tank"};
    RTT::OutputPort<sample::Mode> mode{"mode"};
    RTT::InputPort<double> setpoint{"setpoint"};
    RTT::OutputPort<float> current{"current"};
    double gain = 1.5;
    RTT::PropertyBag limits;
    std::string label = "blue";
};

class Reporting : public types_test::WithBuiltinTypes {
protected:
    static void SetUpTestSuite() {
        types_test::WithBuiltinTypes::SetUpTestSuite();
        sample::addTypes();
    }

    void SetUp() override {
        RTT::os::TimeService::Instance()->enableSystemClock(false);
        reporter.reset(new OCL::ConsoleReporting("Reporter", text));
        reporter->addPeer(&machine);
        reporter->setActivity(new RTT::extras::SlaveActivity(0.01));
    }
    void TearDown() override {
        reporter.reset();
        RTT::os::TimeService::Instance()->enableSystemClock(true);
    }

    template <class T>
    T& property(const std::string& name) {
        auto* const found = dynamic_cast<RTT::Property<T>*>(reporter->getProperty(name));
        if (!found) throw std::runtime_error("no property " + name);
        return found->value();
    }
    void entry(const std::string& kind, const std::string& value) {
        property<RTT::PropertyBag>("ReportData").ownProperty(new RTT::Property<std::string>(kind, "", value));
    }
    /** One cycle, that many seconds later. */
    void cycle(double seconds = 0.5) {
        RTT::os::TimeService::Instance()->secondsChange(seconds);
        reporter->update();
    }
    /** All that was written from start to stop. */
    std::string report() {
        reporter->stop();
        return text.str();
    }
    /** A reporter that is woken by data. */
    void reportOnData() { reporter->setActivity(new RTT::extras::SequentialActivity()); }

    Machine machine;
    std::ostringstream text;
    std::unique_ptr<OCL::ConsoleReporting> reporter;
};

}  // namespace components_test

#endif
