// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYER_CONSOLE_STAY_HPP
#define OROFORGE_DEPLOYER_CONSOLE_STAY_HPP

#include "program.hpp"

namespace OCL::deploy {

/** Stays until the user leaves the console or a signal comes. On a terminal, stays even after a failure, so that the
    user can look into it. */
bool stayAtConsole(DeploymentComponent& deployer, SignalCatcher& ending, const Options& options, bool deployed);

}  // namespace OCL::deploy

#endif
