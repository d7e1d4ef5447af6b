// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Ports that are made at run time, and a tool that finds, lists and taps the ports of components whose types it does not
// know, while they run.
#include <rtt/RTT.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <rtt/os/main.h>
#include <rtt/types/TypeInfo.hpp>

#include <iostream>
#include <memory>

using namespace RTT;

namespace {

/** As many inputs as its property says; they exist from configure() to cleanup(). */
class Sum : public TaskContext {
public:
    explicit Sum(const std::string& name) : TaskContext(name, PreOperational) {
        setActivity(new extras::SequentialActivity());
        addProperty("inputs", inputs_).doc("How many ports to make.");
        addPort("sum", sum_).doc("The sum of the newest sample of each input.");
    }
    ~Sum() override { stopForGood(); }

private:
    bool configureHook() override {
        if (inputs_ < 1) return false;
        removeInputs();
        for (int i = 0; i < inputs_; ++i) {
            in_.push_back(std::make_unique<InputPort<double>>("in" + std::to_string(i)));
            addEventPort(*in_.back());
        }
        return true;
    }
    void updateHook() override {
        double sum = 0, value = 0;
        for (auto& port : in_) {
            if (port->read(value) != NoData) sum += value;
        }
        sum_.write(sum);
    }
    void cleanupHook() override { removeInputs(); }
    void removeInputs() {
        for (auto& port : in_) ports()->removePort(port->getName());
        in_.clear();
    }

    int inputs_ = 2;
    std::vector<std::unique_ptr<InputPort<double>>> in_;
    OutputPort<double> sum_;
};

void list(TaskContext& component) {
    for (base::PortInterface* port : component.ports()->getPorts()) {
        const bool in = dynamic_cast<base::InputPortInterface*>(port);
        std::cout << "  " << port->getFullName() << ": " << (in ? "in" : "out") << ", "
                  << port->getTypeInfo()->getTypeName() << "\n";
        for (const auto& channel : port->getManager()->getConnections()) {
            std::cout << "    " << channel.get<2>() << "\n";  // its ConnPolicy
        }
    }
}

/** Reads any output port of any component without knowing its type. */
class Tap {
public:
    Tap(TaskContext& component, const std::string& name) {
        auto* const port = dynamic_cast<base::OutputPortInterface*>(component.getPort(name));
        if (!port) {
            std::cout << component.getName() << " has no output port '" << name << "'\n";
            return;
        }
        tap_.reset(dynamic_cast<base::InputPortInterface*>(port->antiClone()));  // an input port of the same type
        if (port->createConnection(*tap_, ConnPolicy::buffer(10))) sample_ = tap_->getTypeInfo()->buildValue();
    }
    void print() {
        while (sample_ && tap_->read(sample_) == NewData) std::cout << "  tapped " << sample_ << "\n";
    }

private:
    std::unique_ptr<base::InputPortInterface> tap_;  // disconnects when it is destroyed
    base::DataSourceBase::shared_ptr sample_;        // a variable of its type
};

}  // namespace

int ORO_main(int, char**) {
    Sum sum("sum");
    OutputPort<double> a("a"), b("b");
    sum.configure();
    a.connectTo(sum.getPort("in0"));
    b.connectTo(sum.getPort("in1"), ConnPolicy::circularBuffer(4));
    std::cout << "ports and connections:\n";
    list(sum);

    sum.start();
    {
        Tap tap(sum, "sum");
        a.write(1);
        b.write(20);
        tap.print();
    }
    Tap none(sum, "total");
    std::cout << "the tap is gone: " << (sum.getPort("sum")->connected() ? "no" : "yes") << "\n";

    sum.stop();
    sum.cleanup();
    std::cout << "after cleanup(), a is connected: " << (a.connected() ? "yes" : "no") << "\n";
    list(sum);
    return 0;
}
