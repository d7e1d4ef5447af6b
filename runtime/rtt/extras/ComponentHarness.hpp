// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_EXTRAS_COMPONENT_HARNESS_HPP
#define ORO_EXTRAS_COMPONENT_HARNESS_HPP

#include <rtt/InputPort.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/os/TimeService.hpp>

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <typeindex>
#include <utility>
#include <vector>

namespace RTT {
namespace extras {

/** The samples that a component has written to an output port, at most the last 1000. */
template <class T>
class OutputProbe {
public:
    explicit OutputProbe(const std::string& name) : port_(name) {}

    /** All samples since the last call of all() or last(). */
    std::vector<T> all() {
        std::vector<T> samples;
        T sample{};
        while (port_.read(sample) == NewData) samples.push_back(sample);
        if (!samples.empty()) last_ = std::make_unique<T>(samples.back());
        return samples;
    }

    /** The newest sample. Throws std::logic_error if there is none. */
    T last() {
        all();
        if (!last_) throw std::logic_error("nothing was written to port '" + port_.getName() + "' yet");
        return *last_;
    }

    InputPort<T>& port() { return port_; }

private:
    InputPort<T> port_;
    std::unique_ptr<T> last_;
};

/**
 * Runs a component in the thread of a test, step by step, at times that the test decides.
 *
 *     ComponentHarness harness(component, 0.01);
 *     auto& measured = harness.input<double>("measured");
 *     auto& command = harness.output<double>("command");
 *     ASSERT_TRUE(harness.start());
 *     measured.write(1.0);
 *     harness.step();
 *     EXPECT_EQ(command.last(), 2.0);
 *     EXPECT_EQ(harness.call<int(double)>("count", 0.5), 1);
 *
 * While a harness exists, only step() moves the time of os::TimeService, so that components see exactly one period
 * between executions. So there may be only one harness at a time; add() adds further components. Not thread-safe and
 * only for tests: all functions may allocate, and throw std::logic_error for wrong names.
 */
class ComponentHarness {
public:
    /** Gives `component` an activity that only step() executes. Throws std::logic_error while it runs. */
    explicit ComponentHarness(TaskContext& component, Seconds period = 0.01) : component_(component), period_(period) {
        add(component);
        os::TimeService::Instance()->enableSystemClock(false);
    }

    /** Stops the components, in reverse order, and lets time pass again. */
    ~ComponentHarness() {
        for (auto it = components_.rbegin(); it != components_.rend(); ++it) (*it)->stop();
        os::TimeService::Instance()->enableSystemClock(true);
    }

    ComponentHarness(const ComponentHarness&) = delete;
    ComponentHarness& operator=(const ComponentHarness&) = delete;

    /** Adds a component, which step() executes after earlier ones. */
    void add(TaskContext& component) {
        if (!component.setActivity(new SlaveActivity(period_))) {
            throw std::logic_error("component '" + component.getName() + "' runs: no harness can execute it");
        }
        components_.push_back(&component);
    }

    /** Configures components that are not configured, and starts all. False if one refuses. */
    bool start() {
        for (TaskContext* component : components_) {
            if (!component->isConfigured() && !component->configure()) return false;
            if (!component->isRunning() && !component->start()) return false;
        }
        return true;
    }

    /** Lets a period pass and executes each component once. False if one of them cannot be executed. */
    bool step() {
        os::TimeService::Instance()->secondsChange(period_);
        bool executed = true;
        for (TaskContext* component : components_) executed = component->update() && executed;
        return executed;
    }

    /** Makes the steps in `duration`, at least one. */
    bool step(Seconds duration) {
        bool executed = true;
        Seconds passed = 0;
        // Compares with half a period more, so that rounding does not change the number of steps.
        do {
            executed = step() && executed;
            passed += period_;
        } while (passed + period_ / 2 < duration);
        return executed;
    }

    /** Writes to the input port `name` of the component; connected at the first call, with the port's own policy. */
    template <class T>
    OutputPort<T>& input(const std::string& name) {
        return probe<OutputPort<T>>("input port", name, [this, &name](OutputPort<T>& port) {
            auto* own = dynamic_cast<InputPort<T>*>(component_.getPort(name));
            return own != nullptr && port.createConnection(*own, own->getDefaultPolicy());
        });
    }

    /** Reads what the output port `name` of the component has written since the first call. */
    template <class T>
    OutputProbe<T>& output(const std::string& name) {
        return probe<OutputProbe<T>>("output port", name, [this, &name](OutputProbe<T>& probe) {
            auto* own = dynamic_cast<OutputPort<T>*>(component_.getPort(name));
            return own != nullptr && own->createConnection(probe.port(), ConnPolicy::circularBuffer(1000));
        });
    }

    /** Calls an operation of the component: harness.call<bool(int)>("open", 3). */
    template <class Signature, class... Arguments>
    auto call(const std::string& name, Arguments&&... arguments) {
        if (!component_.provides()->hasOperation(name)) unknown("operation", name);
        OperationCaller<Signature> operation(component_.getOperation(name));
        if (!operation.ready()) unknown("operation of this signature", name);
        return operation(std::forward<Arguments>(arguments)...);
    }

private:
    [[noreturn]] void unknown(const std::string& what, const std::string& name) const {
        throw std::logic_error("component '" + component_.getName() + "' has no " + what + ": '" + name + "'");
    }

    template <class Probe, class Connect>
    Probe& probe(const std::string& what, const std::string& name, const Connect& connect) {
        const auto key = std::make_pair(std::type_index(typeid(Probe)), name);
        const auto known = probes_.find(key);
        if (known != probes_.end()) return *static_cast<Probe*>(known->second.get());
        auto made = std::make_shared<Probe>(name);
        if (!connect(*made)) unknown(what + " of this type", name);
        probes_[key] = made;
        return *made;
    }

    TaskContext& component_;
    const Seconds period_;
    std::vector<TaskContext*> components_;
    std::map<std::pair<std::type_index, std::string>, std::shared_ptr<void>> probes_;
};

}  // namespace extras
}  // namespace RTT

#endif
