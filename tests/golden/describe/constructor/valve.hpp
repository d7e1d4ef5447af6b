#pragma once
#include <rtt/Port.hpp>
#include <rtt/TaskContext.hpp>

namespace valve {

/// Opens and closes.
class Valve : public RTT::TaskContext {
public:
    explicit Valve(const std::string& name);

protected:
    bool configureHook() override;
    void updateHook() override {}

private:
    void open(double by);
    RTT::InputPort<double> wanted_{"wanted", RTT::ConnPolicy::circularBuffer(4)};
    RTT::OutputPort<bool> closed_;
    double speed_ = 0.5;
    std::string label_ = "v \"1\" & <2>";
};

}  // namespace valve
