// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_REPORT_EXPLAIN_HPP
#define OROFORGE_GENERATOR_REPORT_EXPLAIN_HPP

#include <diag/explain.hpp>

namespace oroforge::report {

/// What the codes of the generators mean: the texts of generator/explain/.
const diag::Explanations& explanations();

}  // namespace oroforge::report

#endif
