// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Checks a plan by the descriptions in component libraries. See docs/design/descriptions.md.
#ifndef OROFORGE_DEPLOYMENT_CHECK_DESCRIBED_HPP
#define OROFORGE_DEPLOYMENT_CHECK_DESCRIBED_HPP

#include "validate.hpp"

namespace OCL::deploy {

/**
 * Reports connections of ports that do not fit together, with the messages of checkComponents(), which checks the rest
 * when the components exist. For a plan that is not applied there is no such second check: then ports and properties
 * that are not described, and connections without an output, are errors as well.
 */
void checkDescribed(const Plan& plan, const PlanContext& context, diag::Sink& sink);

}  // namespace OCL::deploy

#endif
