// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Reads adapter files into plain data, checked as far as possible without the C++ that they describe.
#ifndef OROFORGE_GENERATOR_ADAPTERS_READ_ADAPTERS_HPP
#define OROFORGE_GENERATOR_ADAPTERS_READ_ADAPTERS_HPP

#include <string>
#include <vector>

#include <adapters/adapter.hpp>
#include <diag/sink.hpp>

namespace oroforge::adapters {

/// Returns the adapters of the files in their order, then the shipped ones: the first one that fits a class is used.
/// Reports errors TK070, TK071 and TK075, and those of the XML.
std::vector<Adapter> readAdapters(const std::vector<std::string>& files, diag::Sink& sink);

}  // namespace oroforge::adapters

#endif
