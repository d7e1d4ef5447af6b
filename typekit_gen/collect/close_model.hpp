// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What the types imply: the library types and arrays that their fields reach, one order, no two types of one name.
#ifndef OROFORGE_TYPEKIT_GEN_COLLECT_CLOSE_MODEL_HPP
#define OROFORGE_TYPEKIT_GEN_COLLECT_CLOSE_MODEL_HPP

#include <diag/sink.hpp>
#include <model/type_model.hpp>

namespace oroforge::typekit {

/// Fills in library types and arrays, calls template instances by their aliases, and sorts everything by registry
/// name. Two types with one name: error TK060.
/// No type at all: warning TK061.
void closeModel(model::TypeModel& model, diag::Sink& sink);

}  // namespace oroforge::typekit

#endif
