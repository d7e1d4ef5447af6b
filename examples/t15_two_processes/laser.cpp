// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A sensor and its user. Neither knows where the other one is.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>
#include <t15_two_processes/scan.hpp>

#include <atomic>
#include <iostream>

#include <time.h>

namespace laser {

class Scanner : public RTT::TaskContext {
public:
    explicit Scanner(const std::string& name) : TaskContext(name) {
        addPort("scan", scan_).doc("In each cycle.");
        addProperty("reach", reach_).doc("What is further away is not seen, in m.");
        addOperation("measure", &Scanner::measure, this, RTT::OwnThread).doc("One scan, now.");
    }

private:
    Scan measure() {
        Scan scan{getName(), {}};
        for (const double distance : {1.5, 2.5, 3.5})
            if (distance <= reach_) scan.distances.push_back(distance);
        return scan;
    }
    void updateHook() override { scan_.write(measure()); }

    RTT::OutputPort<Scan> scan_;
    double reach_ = 10;
};

class Map : public RTT::TaskContext {
public:
    explicit Map(const std::string& name) : TaskContext(name) {
        addEventPort("scan", scan_).doc("What the map is made of.");
        addOperation("waitForScan", &Map::waitForScan, this, RTT::ClientThread).doc("True when there was one.");
    }

private:
    void updateHook() override {
        Scan scan;
        if (scan_.read(scan) != RTT::NewData || seen_) return;
        std::cout << "map: a scan of " << scan.sensor << " with " << scan.distances.size() << " distances" << std::endl;
        seen_ = true;
    }
    bool waitForScan() const {
        const timespec pause = {0, 10'000'000};
        for (int i = 0; i != 500 && !seen_; ++i) nanosleep(&pause, nullptr);
        return seen_;
    }

    RTT::InputPort<Scan> scan_;
    std::atomic<bool> seen_{false};
};

}  // namespace laser

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(laser::Scanner)
ORO_LIST_COMPONENT_TYPE(laser::Map)
