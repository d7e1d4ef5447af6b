// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Components of a production line, for what the deployment manual says about single elements and operations. They tell on
// standard output when they are configured, started and cleaned up.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>

#include <atomic>
#include <iostream>
#include <sstream>

#include <unistd.h>

namespace line {

/** Counts its cycles and knows the thread of the last one. */
class Counting : public RTT::TaskContext {
public:
    Counting(const std::string& name, TaskState initial) : RTT::TaskContext(name, initial) {
        addOperation("cycles", [this] { return cycles_.load(); });
        addOperation("thread", [this] { return thread_.load(); });
    }

protected:
    void updateHook() override {
        ++cycles_;
        thread_ = ::gettid();
    }
    int cycles() const { return cycles_; }
    bool tell(const std::string& what) const {
        std::cout << getName() + ": " + what + "\n" << std::flush;
        return true;
    }

private:
    std::atomic<int> cycles_{0}, thread_{0};
};

/** Has to be configured, and forgets its speed when it is cleaned up. */
class Worker : public Counting {
public:
    explicit Worker(const std::string& name) : Counting(name, PreOperational) {
        addProperty("speed", speed_).doc("How fast.");
        addProperty("label", label_).doc("What stands on it.");
    }

private:
    bool configureHook() override {
        std::ostringstream values;
        values << "configured with speed " << speed_ << ", label '" << label_ << "'";
        return tell(values.str());
    }
    bool startHook() override { return tell("started after " + std::to_string(cycles()) + " cycles"); }
    void cleanupHook() override {
        speed_ = -1;
        tell("cleaned up");
    }
    double speed_ = 1;
    std::string label_;
};

/** Has its slaves work: those of its peers that it is the master of. */
class Foreman : public Counting {
public:
    explicit Foreman(const std::string& name) : Counting(name, Stopped) {}

private:
    void updateHook() override {
        Counting::updateHook();
        for (const std::string& name : getPeerList()) getPeer(name)->trigger();
    }
};

/** Writes parts; who takes them has ports of the same names, one of them of another type. */
class Source : public RTT::TaskContext {
public:
    explicit Source(const std::string& name) : RTT::TaskContext(name) {
        addPort("parts", parts_);
        addPort("waste", waste_);
        addOperation("put", [this](double part) { parts_.write(part); });
    }

private:
    RTT::OutputPort<double> parts_;
    RTT::OutputPort<int> waste_;
};

class Sink : public RTT::TaskContext {
public:
    explicit Sink(const std::string& name) : RTT::TaskContext(name) {
        addPort("parts", parts_);
        addPort("waste", waste_);
        addOperation("waiting", [this] {
            int number = 0;
            for (double part = 0; parts_.read(part) == RTT::NewData;) ++number;
            return number;
        });
    }

private:
    RTT::InputPort<double> parts_;
    RTT::InputPort<std::string> waste_;
};

}  // namespace line

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(line::Worker)
ORO_LIST_COMPONENT_TYPE(line::Foreman)
ORO_LIST_COMPONENT_TYPE(line::Source)
ORO_LIST_COMPONENT_TYPE(line::Sink)
