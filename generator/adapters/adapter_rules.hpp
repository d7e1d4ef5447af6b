// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The elements and attributes that an adapter file may have.
#ifndef OROFORGE_GENERATOR_ADAPTERS_ADAPTER_RULES_HPP
#define OROFORGE_GENERATOR_ADAPTERS_ADAPTER_RULES_HPP

#include <diag/sink.hpp>
#include <xml/element.hpp>

namespace oroforge::adapters {

/// Reports errors TK070 for whatever the rules do not allow, with the nearest known name. True if there were none.
bool checkStructure(const xml::Element& root, diag::Sink& sink);

}  // namespace oroforge::adapters

#endif
