// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "console_stay.hpp"

#include "../console/kept_terminal.hpp"
#include "../console/wanted.hpp"

#include <ocl/TaskBrowser.hpp>
#include <rtt/Logger.hpp>
#include <rtt/os/SignalCatcher.hpp>

namespace OCL::deploy {

bool stayAtConsole(DeploymentComponent& deployer, SignalCatcher& ending, const Options& options, bool deployed) {
    if (!deployed && (options.daemon || !TaskBrowser::onTerminal())) return true;
    bool succeeded = true;
    if (!options.daemon && console::isWanted()) {
        TaskBrowser browser(&deployer);
        browser.endOn(ending.descriptor());
        RTT::os::beforeSecondSignal(&console::restoreTerminal);
        browser.loop();
        succeeded = !browser.failed();
        if (!ending.caught()) return succeeded;
    }
    RTT::log(RTT::Info) << "ending on signal " << ending.wait() << RTT::endlog();
    return succeeded;
}

}  // namespace OCL::deploy
