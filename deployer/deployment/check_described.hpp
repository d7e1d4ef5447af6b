// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What descriptions in component libraries tell about a plan. See docs/design/descriptions.md.
#ifndef OROFORGE_DEPLOYMENT_CHECK_DESCRIBED_HPP
#define OROFORGE_DEPLOYMENT_CHECK_DESCRIBED_HPP

#include "validate.hpp"

namespace OCL::deploy {

/**
 * Reports connections of ports that do not fit each other, by the words of checkComponents(), which says the rest when the
 * components are there. A plan that is not to be applied has no such second look: ports and properties that no description
 * names are errors then, and connections without an output.
 */
void checkDescribed(const Plan& plan, const Surroundings& surroundings, diag::Sink& sink);

}  // namespace OCL::deploy

#endif
