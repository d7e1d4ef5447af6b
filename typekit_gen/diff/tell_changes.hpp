// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Reports changes of a package's types as diagnostics, and sums them up in one line.
#ifndef OROFORGE_TYPEKIT_GEN_DIFF_TELL_CHANGES_HPP
#define OROFORGE_TYPEKIT_GEN_DIFF_TELL_CHANGES_HPP

#include <string>
#include <vector>

#include <diag/sink.hpp>
#include <diff/compare_models.hpp>

namespace oroforge::typekit {

/// Reports breaking changes as errors TK064, the others as notes.
void tellChanges(const std::vector<Change>& changes, diag::Sink& sink);

/// Returns "breaking: 2 changes break, 1 does not", "compatible: 1 change" or "compatible: no change".
std::string verdict(const std::vector<Change>& changes);

}  // namespace oroforge::typekit

#endif
