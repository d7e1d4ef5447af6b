// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What one plugin knows of the type S of each change.
#include <changes/typekit/Types.hpp>

extern "C" __attribute__((visibility("default"))) const RTT::types::Schema* schemaOfChange(int number);

const RTT::types::Schema* schemaOfChange(int number) {
    static const RTT::types::Schema& (*const all[])() = {
#include "schemas.inc"
    };
    return &all[number]();
}
