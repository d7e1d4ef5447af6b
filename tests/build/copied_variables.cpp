// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Compiled for a fixed address: the program has copies of the library's variables, which both must use.
#include <rtt/Port.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/internal/flow/reclaimer.hpp>
#include <rtt/os/main.h>

#include <iostream>

using namespace RTT;

namespace {

int faults = 0;

void require(bool condition, const char* what) {
    if (condition) return;
    std::cerr << "error: " << what << "\n";
    ++faults;
}

/** An object that was retired before this thread came in is destroyed while it is inside. */
void reclaiming() {
    typedef internal::Reclaimer Reclaimer;
    bool destroyed = false;
    Reclaimer::retire(&destroyed, [](void* object) { *static_cast<bool*>(object) = true; });
    const Reclaimer::Guard guard;
    Reclaimer::collect();
    require(destroyed, "the program announces another epoch than that of the library");
}

void samples() {
    {
        TaskContext component("component");
        component.setActivity(new extras::SlaveActivity());
        OutputPort<double> out("out");
        InputPort<double> in("in");
        int calls = 0;
        component.addEventPort(in, [&](base::PortInterface*) { ++calls; });
        require(component.start() && out.connectTo(&in), "could not connect");
        double sample = 2;
        require(out.write(sample) == WriteSuccess && component.update() && calls == 1, "the callback was not called");
        require(in.read(sample) == NewData && sample == 2, "the sample did not arrive");
    }
    require(internal::Reclaimer::pending() == 0, "a connection was not destroyed");
}

}  // namespace

int ORO_main(int, char**) {
    samples();
    reclaiming();
    return faults;
}
