// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A tank with two valves. What it does with them is left to scripts.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>

#include <algorithm>
#include <iostream>

namespace filling {

class Tank : public RTT::TaskContext {
public:
    explicit Tank(const std::string& name) : RTT::TaskContext(name, PreOperational) {
        addProperty("capacity", capacity).doc("What it holds, in m3.");
        addProperty("flow", flow).doc("What goes through a valve, in m3 per cycle.");
        addAttribute("level", level);
        addPort("emergency", emergency).doc("Why everything has to stop.");
        addOperation("inlet", [this](bool open) { inletOpen = open; })
            .doc("Opens or closes the upper valve.")
            .arg("open", "");
        addOperation("outlet", [this](bool open) { outletOpen = open; })
            .doc("Opens or closes the lower valve.")
            .arg("open", "");
        addOperation("say", &Tank::say, this).doc("Prints a line.").arg("what", "");
    }
    ~Tank() override { stopForGood(); }

private:
    bool configureHook() override { return capacity > 0 && flow > 0; }
    void updateHook() override {
        if (inletOpen) level = std::min(capacity, level + flow);
        if (outletOpen) level = std::max(0.0, level - flow);
    }
    void say(const std::string& what) { std::cout << getName() << ": " << what << std::endl; }

    double capacity = 1, flow = 0, level = 0;
    bool inletOpen = false, outletOpen = false;
    RTT::InputPort<std::string> emergency;
};

}  // namespace filling

ORO_CREATE_COMPONENT(filling::Tank)
