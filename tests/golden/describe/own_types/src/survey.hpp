#pragma once
#include <rtt/RTT.hpp>
#include <survey/point.hpp>
#include <survey/quality.hpp>

namespace survey {

struct Settings {
    int count = 0;
};

class Survey : public RTT::TaskContext {
public:
    explicit Survey(const std::string& name);

private:
    bool check(const Rated<int>& sample, Quality* least);

    RTT::InputPort<std::vector<Point>> points_;
    RTT::OutputPort<double> mean_;
    Settings settings_;
};

}  // namespace survey
