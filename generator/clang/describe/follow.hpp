// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Follows the constructor of a component as a processor would, as far as its source tells what happens:
///
///     follow              makes the classes below, and begins
///     evaluator.hpp       statements, expressions, calls, objects; texts and containers of the standard library
///     memory, call_stack  what variables hold; the functions that are being followed
///     interface_calls.hpp constructors and functions of RTT: what they add to the registry
///     registry            ports, properties, services …, and which scope they were added to
///     interface_result    the interface that came out of it
///     late_calls          functions that the constructor does not call
///     findings            what is not certain, and remarks
///
/// What cannot be told is a remark (a warning with a place); what is done there is left out.
#ifndef OROFORGE_GENERATOR_CLANG_DESCRIBE_FOLLOW_HPP
#define OROFORGE_GENERATOR_CLANG_DESCRIBE_FOLLOW_HPP

#include <clang/base/source_places.hpp>
#include <diag/sink.hpp>

#include "component_state.hpp"

namespace oroforge::cxx {

/// Makes an object of the class with this constructor, whose parameters are not known.
Followed follow(const clang::CXXConstructorDecl& constructor, const SourcePlaces& places, diag::Sink& remarks);

}  // namespace oroforge::cxx

#endif
