// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// One component writes scans, the other prints them. Neither knows where the other one is.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>
#include <t14_queues/scan.hpp>

#include <iostream>

namespace laser {

class Scanner : public RTT::TaskContext {
public:
    explicit Scanner(const std::string& name) : TaskContext(name) { addPort("scan", scan_); }

private:
    bool startHook() override {
        std::cout << "scanner: started" << std::endl;
        return true;
    }
    void updateHook() override { scan_.write({"front", {1.5, 2.5, 3.5}}); }

    RTT::OutputPort<Scan> scan_;
};

class Map : public RTT::TaskContext {
public:
    explicit Map(const std::string& name) : TaskContext(name) {
        addEventPort("scan", scan_).doc("What the map is made of.");
    }

private:
    void updateHook() override {
        Scan scan;
        if (scan_.read(scan) != RTT::NewData || ++count_ > 3) return;
        std::cout << "map: a scan of " << scan.sensor << " with " << scan.distances.size() << " distances, the last is "
                  << scan.distances.back() << " m" << std::endl;
        if (count_ == 3) std::cout << "map: done" << std::endl;
    }

    RTT::InputPort<Scan> scan_;
    int count_ = 0;
};

}  // namespace laser

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(laser::Scanner)
ORO_LIST_COMPONENT_TYPE(laser::Map)
