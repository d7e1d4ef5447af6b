// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Checks that fields that are marked as the time of their struct can be one.
#ifndef OROFORGE_TYPEKIT_GEN_COLLECT_CHECK_STAMPS_HPP
#define OROFORGE_TYPEKIT_GEN_COLLECT_CHECK_STAMPS_HPP

#include <diag/sink.hpp>
#include <model/type_model.hpp>

namespace oroforge::typekit {

/// Warning TK084 for the first field of a struct with the word `@stamp` in its comment, if recorders cannot take it as
/// a time. They take what RTT::encoding::Stamp does. Structs that the model does not have are not looked into.
void checkStamps(const model::TypeModel& model, diag::Sink& sink);

}  // namespace oroforge::typekit

#endif
