// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Completes a model: adds the library types and arrays that fields use, sorts all types and checks their names.
#ifndef OROFORGE_TYPEKIT_GEN_COLLECT_CLOSE_MODEL_HPP
#define OROFORGE_TYPEKIT_GEN_COLLECT_CLOSE_MODEL_HPP

#include <diag/sink.hpp>
#include <model/type_model.hpp>

namespace oroforge::typekit {

/// Adds the library types and arrays that fields use, calls template instances by their aliases, and sorts everything
/// by registry name. Two types with one name are error TK060; a model without types is warning TK061.
void closeModel(model::TypeModel& model, diag::Sink& sink);

}  // namespace oroforge::typekit

#endif
