// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYER_CRASH_REPORT_HPP
#define OROFORGE_DEPLOYER_CRASH_REPORT_HPP

namespace OCL::deploy {

/** Installs handlers that write the component and place of a crash to standard error. Then the previous handler runs,
    or the signal has its usual effect. */
void reportCrashes();

}  // namespace OCL::deploy

#endif
