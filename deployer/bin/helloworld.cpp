// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// helloworld-<target>: a component that has one of everything, and a console to try it. It deploys nothing.
#include <ocl/HelloWorld.hpp>
#include <ocl/TaskBrowser.hpp>
#include <rtt/os/main.h>

#include <cstring>
#include <iostream>

int ORO_main(int argc, char** argv) {
    if (argc > 1) {
        const bool asked = argc == 2 && (std::strcmp(argv[1], "--help") == 0 || std::strcmp(argv[1], "-h") == 0);
        (asked ? std::cout : std::cerr) << "Usage: " << argv[0]
                                        << "\nOpens a console on the component 'hello', an OCL::HelloWorld.\n";
        return asked ? 0 : 255;
    }
    OCL::HelloWorld hello("hello");
    OCL::TaskBrowser browser(&hello);
    browser.loop();
    return browser.failed() ? 255 : 0;
}
