// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_EXPLAIN_EXPLANATIONS_HPP
#define OROFORGE_GENERATOR_EXPLAIN_EXPLANATIONS_HPP

#include <diag/explain.hpp>

namespace oroforge::explain {

/// The explanations of the generators' codes, from generator/explain/.
const diag::Explanations& explanations();

}  // namespace oroforge::explain

#endif
