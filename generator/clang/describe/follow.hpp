// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Follows the constructor of a component as a processor would, as far as its source shows what happens:
///
///     follow              makes the parts below, and begins
///     evaluator.hpp       statements, expressions, calls, objects; texts and containers of the standard library
///     memory, call_stack  values of variables; the functions that are being followed
///     interface_calls.hpp constructors and functions of RTT: what they add to the registry
///     registry            ports, properties, services …, and their scopes
///     interface_result    the resulting interface
///     late_calls          functions that the constructor does not call
///     findings            doubts and remarks
///
/// What the source does not reveal is a remark (a warning with a place), and is left out.
#ifndef OROFORGE_GENERATOR_CLANG_DESCRIBE_FOLLOW_HPP
#define OROFORGE_GENERATOR_CLANG_DESCRIBE_FOLLOW_HPP

#include <clang/base/source_places.hpp>
#include <diag/sink.hpp>

#include "component_state.hpp"

namespace oroforge::cxx {

/// Makes an object of the class with this constructor; values of its parameters are unknown.
Followed follow(const clang::CXXConstructorDecl& constructor, const SourcePlaces& places, diag::Sink& remarks);

}  // namespace oroforge::cxx

#endif
