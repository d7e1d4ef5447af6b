// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Adapter files to plain data: XML, checked as far as it can be without the C++ that it is about.
#ifndef OROFORGE_GENERATOR_ADAPTERS_READ_ADAPTERS_HPP
#define OROFORGE_GENERATOR_ADAPTERS_READ_ADAPTERS_HPP

#include <string>
#include <vector>

#include <adapters/adapter.hpp>
#include <diag/sink.hpp>

namespace oroforge::adapters {

/// Those of the files, in their order, and behind them those that are shipped: the first one that fits a class is taken.
/// Errors TK070, TK071 and TK075, and those of the XML, are in the sink.
std::vector<Adapter> readAdapters(const std::vector<std::string>& files, diag::Sink& sink);

}  // namespace oroforge::adapters

#endif
