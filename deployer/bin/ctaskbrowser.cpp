// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// ctaskbrowser-<target>: a console for a component of another process.
#include "../console/kept_terminal.hpp"

#include <ocl/TaskBrowser.hpp>
#include <rtt/Logger.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/os/SignalCatcher.hpp>
#include <rtt/os/startstop.h>
#include <rtt/transports/corba/TaskContextProxy.hpp>
#include <rtt/transports/corba/TaskContextServer.hpp>

#include <cstring>
#include <iostream>
#include <memory>
#include <string>

#include <signal.h>

namespace {

using RTT::corba::TaskContextProxy;
using RTT::corba::TaskContextServer;

constexpr int kFailure = 255;

const char kUsage[] =
    "Usage: ctaskbrowser NAME|IOR:… [options of the ORB]\n\n"
    "A console for a component of another process, such as the Deployer of cdeployer. It is found by its name in the\n"
    "naming service, or by its reference. Leaving the console leaves the component as it is.\n\n"
    "Example: ctaskbrowser Deployer -ORBInitRef NameService=corbaloc::localhost/NameService\n";

/** The component, which is deleted with the result; null, with an error logged, if there is none. */
std::unique_ptr<TaskContextProxy> find(const std::string& name) {
    const bool isReference = name.compare(0, 4, "IOR:") == 0 || name.compare(0, 8, "corbaloc") == 0;
    return std::unique_ptr<TaskContextProxy>(TaskContextProxy::Create(name, isReference));
}

bool browse(const std::string& name) {
    RTT::os::SignalCatcher ending({SIGINT, SIGTERM, SIGHUP});
    std::string error;  // types of packages that are not there are reported when they are needed
    (void)RTT::ComponentLoader::Instance()->importInstalled("ocl", error);
    const std::unique_ptr<TaskContextProxy> component = find(name);
    if (!component) return false;
    OCL::TaskBrowser browser(component.get());
    browser.endOn(ending.descriptor());
    RTT::os::beforeSecondSignal(&OCL::console::restoreTerminal);
    browser.loop();
    return !browser.failed();
}

int run(int argc, char** argv) {
    if (__os_init(argc, argv) != 0) return kFailure;
    const RTT::Logger::In in("ctaskbrowser");
    bool succeeded = false;
    try {
        succeeded = TaskContextServer::InitOrb(argc, argv) && browse(argv[1]);
    } catch (const std::exception& thrown) {
        RTT::log(RTT::Critical) << "uncaught exception: " << thrown.what() << RTT::endlog();
    }
    TaskContextServer::DestroyOrb();
    __os_exit();
    return succeeded ? 0 : kFailure;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string first = argc > 1 ? argv[1] : "";
    if (first == "--version") {
        std::cout << "ctaskbrowser " ORO_STRINGIFY(RTT_VERSION) " (Oroforge, target " OROCOS_TARGET_NAME ")\n";
        return 0;
    }
    if (first.empty() || first[0] == '-') {
        std::cerr << kUsage;
        return kFailure;
    }
    return run(argc, argv);
}
