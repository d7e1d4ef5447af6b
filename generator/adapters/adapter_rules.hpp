// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Which elements and attributes an adapter file may have.
#ifndef OROFORGE_GENERATOR_ADAPTERS_ADAPTER_RULES_HPP
#define OROFORGE_GENERATOR_ADAPTERS_ADAPTER_RULES_HPP

#include <diag/sink.hpp>
#include <xml/element.hpp>

namespace oroforge::adapters {

/// Errors TK070 for everything that the rules do not allow, with the nearest known name. True if there was none.
bool checkStructure(const xml::Element& root, diag::Sink& sink);

}  // namespace oroforge::adapters

#endif
