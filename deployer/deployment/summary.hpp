// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_SUMMARY_HPP
#define OROFORGE_DEPLOYMENT_SUMMARY_HPP

#include <string>

namespace OCL::deploy {

struct Session;

/** How many components and connections the files describe that were only planned. */
std::string summaryOf(const Session& session);

}  // namespace OCL::deploy

#endif
