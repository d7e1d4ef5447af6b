// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYER_CRASH_REPORT_HPP
#define OROFORGE_DEPLOYER_CRASH_REPORT_HPP

namespace OCL::deploy {

/** From now on a crash of the process says on standard error in which component it happened, and where, before it has its
    usual effect. Who handles such a signal already does so afterwards. */
void tellCrashes();

}  // namespace OCL::deploy

#endif
