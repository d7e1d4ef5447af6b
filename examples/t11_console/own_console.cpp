// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A program of its own with a console for one component.
#include <ocl/TaskBrowser.hpp>
#include <rtt/RTT.hpp>
#include <rtt/os/main.h>

#include <iostream>

namespace {

class Lamp : public RTT::TaskContext {
public:
    Lamp() : TaskContext("lamp") {
        addProperty("brightness", brightness_).doc("How bright it is while it is on. [cd]");
        addOperation("light", &Lamp::light, this).doc("Switches it on or off.").arg("on", "");
    }

private:
    void light(bool on) { std::cout << "lamp: " << (on ? brightness_ : 0) << " cd" << std::endl; }

    double brightness_ = 10;
};

}  // namespace

int ORO_main(int, char**) {
    Lamp lamp;
    OCL::TaskBrowser browser(&lamp);
    browser.evaluate("brightness = 25.0");
    browser.loop();
    return 0;
}
