// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component that executes state machines of scripts, step by step.
#ifndef OROFORGE_TESTS_SCRIPTING_MACHINE_STATION_HPP
#define OROFORGE_TESTS_SCRIPTING_MACHINE_STATION_HPP

#include <rtt/RTT.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <rtt/scripting/ScriptingService.hpp>
#include <unit/flow/log_capture.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <regex>
#include <stdexcept>
#include <string>

namespace machine_test {

using RTT::scripting::StateMachine;
using RTT::scripting::StateMachinePtr;
typedef StateMachine::Status Status;

/** Scripts call note(), fail() and act(), listen to pressed() and moved(), read the ports and change the attributes. */
class Station : public RTT::TaskContext {
public:
    explicit Station(const std::string& name = "station", double period = 0.01)
        : RTT::TaskContext(name), in("in"), out("out") {
        setActivity(new RTT::extras::SlaveActivity(period));
        addAttribute("count", count);
        addAttribute("go", go);
        addOperation("note", &Station::note, this);
        addOperation("fail", &Station::fail, this);
        addOperation("act", [this] { does(); });
        addEventOperation("pressed", [](int) {});
        addEventOperation("moved", [](double, const std::string&) {});
        addOperation("quiet", [](int) {});
        addPort(in);
        out.connectTo(&in);
    }
    ~Station() override { stop(); }

    std::string take() {
        std::string taken;
        taken.swap(trace);
        return taken;
    }
    /** What the programs noted in one step. */
    std::string step() {
        take();
        EXPECT_TRUE(update());
        return take();
    }

    int count = 0;
    bool go = false;
    std::string trace;
    std::function<void()> does = [] {};
    RTT::InputPort<int> in;
    RTT::OutputPort<int> out;

private:
    void note(const std::string& text) { trace += (trace.empty() ? "" : " ") + text; }
    void fail() { throw std::runtime_error("the motor is stuck"); }
};

class MachineTest : public testing::Test {
protected:
    MachineTest() {
        const auto loader = RTT::plugin::PluginLoader::Instance();
        loader->loadLibrary(RTT_TYPEKIT_FILE);
        RTT::Logger::Instance()->setLogLevel(RTT::Logger::Info);
        service = RTT::scripting::ScriptingService::Create(&station);
        logged();
    }

    /** Loads machine `m`. */
    StateMachinePtr load(const std::string& script) {
        EXPECT_TRUE(service->eval(script)) << logged();
        const StateMachinePtr machine = service->getStateMachine("m");
        if (!machine) throw std::runtime_error("no state machine 'm'");
        return machine;
    }
    template <class Value>
    Value attribute(const std::string& name, const std::string& path = "m") {
        RTT::Service::shared_ptr at = station.provides();
        std::istringstream parts(path);
        for (std::string part; std::getline(parts, part, '.');) at = at ? at->getService(part) : at;
        RTT::base::AttributeBase* const found = at ? at->getAttribute(name) : nullptr;
        auto* const value = found ? RTT::internal::DataSource<Value>::narrow(found->getDataSource().get()) : nullptr;
        EXPECT_TRUE(value) << name;
        return value ? value->get() : Value();
    }
    /** What the log said since the last time, from level Error on unless said, without times and modules. */
    std::string logged(const std::string& levels = "ERROR|CRITICAL") {
        const std::string text = log_.text().substr(seen_);
        seen_ += text.size();
        // Errors of scripts begin with their place, all else with the time and the level.
        const std::regex start(
            "(?:^|\n)(?:[0-9.]+ +\\[ *([A-Za-z]+) *\\]\\[[^\\]]*\\] "
            "|(?=[^ \n][^\n]*:[0-9]+:[0-9]+: (error|warning): ))");
        std::string result;
        for (std::sregex_iterator line(text.begin(), text.end(), start), end; line != end;) {
            const std::smatch match = *line;
            const auto begin = match[0].second;
            const auto until = ++line == end ? text.end() : (*line)[0].first;
            const std::string level = match[1].matched ? match[1] : match[2];
            if (std::regex_match(level, std::regex(levels, std::regex::icase))) {
                const std::string said(begin, until);
                result += said + (said.back() == '\n' ? "" : "\n");
            }
        }
        return result;
    }

    flow_test::LogCapture log_;
    std::size_t seen_ = 0;
    Station station;
    RTT::scripting::ScriptingService::shared_ptr service;
};

}  // namespace machine_test

#endif
