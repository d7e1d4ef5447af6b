// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component of C++ for scripts: ports, properties, operations of every kind, requesters.
#ifndef OROFORGE_TESTS_LUA_ZOO_HPP
#define OROFORGE_TESTS_LUA_ZOO_HPP

#include "types/sample_types.hpp"

#include <rtt/Activity.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/TaskContext.hpp>

#include <stdexcept>
#include <string>

namespace lua_test {

class Zoo : public RTT::TaskContext {
public:
    explicit Zoo(const std::string& name) : RTT::TaskContext(name, PreOperational) {
        setActivity(new RTT::Activity());
        addPort("numbers_in", numbersIn_).doc("Numbers");
        addPort("numbers_out", numbersOut_).doc("The numbers again");
        addPort("tank_in", tankIn_);
        addPort("tank_out", tankOut_);
        addProperty("gain", gain_).doc("A factor");
        addProperty("tank", tank_).doc("A tank");
        addProperty("names", names_);
        addAttribute("count", count_);
        addConstant("limit", limit_);
        addOperation("add", &Zoo::add, this).doc("Adds").arg("a", "one").arg("b", "other");
        addOperation("halve", &Zoo::halve, this, RTT::OwnThread).doc("Halves").arg("number", "in and out");
        addOperation("divide", &Zoo::divide, this, RTT::OwnThread).arg("a", "").arg("b", "").arg("rest", "out");
        addOperation("fill", &Zoo::fill, this).arg("tank", "in and out").arg("level", "");
        addOperation("mode", &Zoo::mode, this).arg("mode", "");
        addOperation("greet", &Zoo::greet, this, RTT::OwnThread).arg("who", "");
        addOperation("fail", &Zoo::fail, this);
        addOperation("nothing", &Zoo::nothing, this);
        addOperation("getName", &Zoo::other, this).doc("Hides the method of the binding");
        provides("inner")->doc("An inner service");
        provides("inner")->addOperation("twice", &Zoo::twice, this).doc("Doubles").arg("x", "");
        provides("inner")->addProperty("depth", depth_);
        provides("inner")->addAttribute("mark", count_);
        provides("inner")->addPort("inner_out", innerOut_);
        provides("inner")->provides("most")->addOperation("deep", &Zoo::nothing, this);
        requires_("helper")->addOperationCaller(help_);
    }
    ~Zoo() override { stopForGood(); }

private:
    double add(double a, double b) { return a + b; }
    void halve(double& number) { number /= 2; }
    int divide(int a, int b, int& rest) {
        if (b == 0) throw std::domain_error("division by nothing");
        rest = a % b;
        return a / b;
    }
    double fill(sample::Tank& tank, double level) {
        tank.levels.push_back(level);
        tank.mode = sample::Mode::Filling;
        return static_cast<double>(tank.levels.size());
    }
    sample::Mode mode(sample::Mode mode) { return mode; }
    std::string greet(const std::string& who) { return "hello " + who; }
    void fail() { throw std::runtime_error("as asked"); }
    void nothing() {}
    std::string other() { return "the operation"; }
    double twice(double x) { return 2 * x; }
    void updateHook() override {
        double number = 0;
        while (numbersIn_.read(number) == RTT::NewData) numbersOut_.write(number * gain_);
        sample::Tank tank;
        while (tankIn_.read(tank) == RTT::NewData) tankOut_.write(tank);
    }

    RTT::InputPort<double> numbersIn_;
    RTT::OutputPort<double> numbersOut_;
    RTT::InputPort<sample::Tank> tankIn_;
    RTT::OutputPort<sample::Tank> tankOut_;
    RTT::OutputPort<double> innerOut_;
    double gain_ = 1;
    sample::Tank tank_;
    std::vector<std::string> names_;
    int count_ = 3;
    int limit_ = 9;
    double depth_ = 2.5;
    RTT::OperationCaller<double(double)> help_{"twice"};
};

}  // namespace lua_test

#endif
