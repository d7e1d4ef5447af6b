// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Scripts from C++: text that is executed at once, a function that is called like any operation, a program step by step.
#include <rtt/RTT.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/os/main.h>
#include <rtt/scripting/Scripting.hpp>

#include <iostream>

using namespace RTT;

int ORO_main(int, char**) {
    Logger::Instance()->setLogLevel(Logger::Never);  // what is logged carries the time
    TaskContext axis("axis");
    axis.setActivity(new extras::SlaveActivity(0.01));
    double position = 1;
    axis.addAttribute("position", position);
    axis.addOperation("show", [&position] { std::cout << "position " << position << "\n"; });

    const auto scripting = axis.getProvider<Scripting>("scripting");
    const bool executed = scripting->eval("position = 2.0 * position + 0.5; show()");
    const bool wrong = scripting->eval("positon = 3");
    std::cout << std::boolalpha << "executed: " << executed << ", with an error: " << wrong << "\n";

    scripting->eval("export double mirrored(double x) { return 2.0 * position - x }");
    OperationCaller<double(double)> mirrored(axis.getOperation("mirrored"));
    std::cout << "mirrored: " << mirrored(1) << "\n";

    scripting->loadProgramText("program move { while position < 4.0 { position = position + 1; show(); yield } }");
    scripting->startProgram("move");
    axis.start();
    for (int cycle = 1; scripting->isProgramRunning("move"); ++cycle) {
        std::cout << "cycle " << cycle << "\n";
        axis.update();
    }
    return 0;
}
