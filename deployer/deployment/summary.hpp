// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_SUMMARY_HPP
#define OROFORGE_DEPLOYMENT_SUMMARY_HPP

#include <string>

namespace OCL::deploy {

struct Session;

/** The numbers of components and connections that the planned files describe. */
std::string summaryOf(const Session& session);

}  // namespace OCL::deploy

#endif
