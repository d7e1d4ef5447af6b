// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What the scripts of the corpus run in: a component that a script steps by hand, with a peer that has a thread.
#ifndef OROFORGE_TESTS_SCRIPTING_CORPUS_ROBOT_HPP
#define OROFORGE_TESTS_SCRIPTING_CORPUS_ROBOT_HPP

#include <rtt/RTT.hpp>

#include <condition_variable>
#include <mutex>
#include <string>
#include <vector>

namespace scripting_corpus {

/** Loads the built-in typekit and the scripting plugin, adds types that scripts use besides (`ints`, `strings`, `geo.Point`, `Colour`)
    and a global service, `texts`. Does nothing the second time. */
void loadTypesAndScripting();

/** In the thread of its own, for calls from component to component. */
class Worker : public RTT::TaskContext {
public:
    explicit Worker(const std::string& name);
    ~Worker() override;

    int offset = 0;

private:
    int add(int a, int b) const { return a + b + offset; }
    void swapValues(int& a, int& b) const { std::swap(a, b); }
    int split(double value, double& rest) const;
    int waitForRelease(int result);
    void release();
    int fail() const;

    std::mutex mutex_;
    std::condition_variable released_;
    int permits_ = 0;
};

/** Every kind of thing that a script can name. */
class Robot : public RTT::TaskContext {
public:
    Robot();
    ~Robot() override;

    /** What the script said, in order. */
    std::vector<std::string> notes() const;
    /** Executes its engine that often. */
    void step(int times);

private:
    void addValues();
    void addFunctions();
    void addServices();
    void addPorts();
    void note(const std::string& text);
    void show(const std::string& path);
    int add(int a, int b) const { return a + b; }
    std::string greet(const std::string& name) const { return "hello " + name; }
    double half(double value) const { return value / 2; }
    void swapValues(int& a, int& b) const { std::swap(a, b); }
    int& element(int index) { return cells_[index]; }
    bool refuse() const { return false; }
    void fail() const;
    bool truth(const std::string& name, bool value);
    bool comeAndGo(const std::string& script) const;

    /** No typekit knows it. */
    struct Secret {};

    mutable std::mutex mutex_;
    std::vector<std::string> notes_;
    bool flag_ = false;
    int whole_ = 0;
    unsigned natural_ = 0;
    long long wide_ = 0;
    unsigned long long wide_natural_ = 0;
    float single_ = 0;
    double real_ = 0;
    char letter_ = 0;
    std::string text_;
    std::vector<double> list_;
    std::vector<std::string> names_;
    std::vector<int> numbers_;
    RTT::ConnPolicy policy_;
    RTT::FlowStatus flow_ = RTT::NoData;
    RTT::SendStatus sent_ = RTT::SendNotReady;
    RTT::WriteStatus written_ = RTT::NotConnected;
    double gain_ = 1.5;
    RTT::PropertyBag limits_;
    double lower_ = -1, upper_ = 1, speed_ = 0.5;
    int force_ = 0;
    const int serial_ = 4711;
    int cells_[3] = {10, 20, 30};
    RTT::Operation<void(int)> moved_{"moved"};
    RTT::Operation<void(std::string, double)> measured_{"measured"};
    RTT::OutputPort<int> out_{"out"};
    RTT::InputPort<int> in_{"in"};
    RTT::OutputPort<std::string> jobs_{"jobs"};
    RTT::InputPort<std::string> work_{"work"};
    RTT::OutputPort<int> loose_{"loose"};
    RTT::InputPort<Secret> opaque_{"opaque"};
    RTT::Operation<void(Secret)> guessed_{"guessed"};
    Worker other_{"other"};
};

}  // namespace scripting_corpus

#endif
