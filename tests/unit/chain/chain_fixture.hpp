// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A chain that the test steps itself, and members that write down what they do.
#ifndef OROFORGE_TESTS_CHAIN_FIXTURE_HPP
#define OROFORGE_TESTS_CHAIN_FIXTURE_HPP

#include <fbsched/fbsched.hpp>
#include <ocl/Chain.hpp>
#include <rtt/Activity.hpp>
#include <rtt/Logger.hpp>
#include <rtt/Property.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <types/builtin_typekit.hpp>

#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace chain_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
typedef std::vector<std::string> Strings;

/** What the log says meanwhile. */
class LogText {
public:
    LogText() { RTT::Logger::Instance()->setStdStream(text_); }
    ~LogText() { RTT::Logger::Instance()->setStdStream(std::cerr); }
    std::string operator()() const { return text_.str(); }

private:
    std::ostringstream text_;
};

class Member : public RTT::TaskContext {
public:
    Member(const std::string& name, Strings* trace) : RTT::TaskContext(name), trace_(trace) {
        addEventPort("event", event);
        addPort("in", in);
        addPort("out", out);
        addOperation("hello", &Member::hello, this, RTT::OwnThread);
    }
    ~Member() override { stopForGood(); }

    void updateHook() override {
        ++updates;
        if (trace_) trace_->push_back(getName());
        if (each) each();
    }
    std::string hello() {
        if (trace_) trace_->push_back(getName() + ".hello");
        return "hello from " + getName();
    }
    bool startHook() override {
        if (trace_ && traceLife) trace_->push_back(getName() + " starts");
        return starts;
    }
    void stopHook() override {
        if (trace_ && traceLife) trace_->push_back(getName() + " stops");
    }

    std::atomic<int> updates{0};
    std::function<void()> each;
    bool starts = true, traceLife = false;
    RTT::InputPort<int> event{"event"}, in{"in"};
    RTT::OutputPort<int> out{"out"};

private:
    Strings* const trace_;
};

template <class T>
void set(RTT::TaskContext& component, const std::string& name, const T& value) {
    auto* const property = dynamic_cast<RTT::Property<T>*>(component.getProperty(name));
    ASSERT_TRUE(property) << name;
    property->set(value);
}

class Chained : public types_test::WithBuiltinTypes {
protected:
    void SetUp() override { period(0.001); }
    void TearDown() override {
        if (chain) chain->stop();
    }

    /** A period of 0: only samples and step() are cycles. */
    void period(double seconds) { chain->setActivity(new RTT::extras::SlaveActivity(seconds)); }
    /** A thread for the chain. Before members are added. */
    void thread(double seconds) {
        chain->setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, seconds, nullptr, "chain"));
    }
    std::unique_ptr<Member> make(const std::string& name) { return std::make_unique<Member>(name, &trace); }
    static void enslave(RTT::TaskContext& master, RTT::TaskContext& slave) {
        slave.setActivity(new RTT::extras::SlaveActivity(master.getActivity()));
        master.addPeer(&slave);
    }
    Member& add(const std::string& name, bool started = true) {
        members.push_back(make(name));
        enslave(*chain, *members.back());
        EXPECT_TRUE(!started || members.back()->start());
        members.back()->updates = 0;  // a slave executes one step when it starts
        return *members.back();
    }
    Member& operator[](const std::string& name) {
        for (const auto& member : members)
            if (member->getName() == name) return *member;
        throw std::runtime_error("no member " + name);
    }
    void order(const Strings& names) { set(*chain, "sched_order", names); }
    /** The trace of one cycle. */
    Strings cycle() {
        trace.clear();
        EXPECT_TRUE(chain->update());
        return trace;
    }
    OCL::ChainMember statistics(const std::string& name) {
        for (const OCL::ChainMember& member : chain->stats().members)
            if (member.name == name) return member;
        throw std::runtime_error("no statistics of " + name);
    }
    static bool within(double seconds, const std::function<bool()>& done) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
        while (!done() && std::chrono::steady_clock::now() < end)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return done();
    }

    Strings trace;
    std::unique_ptr<OCL::Chain> chain{new OCL::Chain("chain")};
    std::vector<std::unique_ptr<Member>> members;  // destroyed first
};

}  // namespace chain_test

#endif
