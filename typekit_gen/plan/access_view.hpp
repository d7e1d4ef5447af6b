// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Describes access to a part of an object, for templates/typekit/access_*.mustache.
#ifndef OROFORGE_TYPEKIT_GEN_PLAN_ACCESS_VIEW_HPP
#define OROFORGE_TYPEKIT_GEN_PLAN_ACCESS_VIEW_HPP

#include <model/field_access.hpp>
#include <nlohmann/json.hpp>

namespace oroforge::typekit {

/// Keys: get; the name of its kind, which is true; if present set, number, pointee, assigned, address.
nlohmann::json accessView(const model::FieldAccess& access);

}  // namespace oroforge::typekit

#endif
