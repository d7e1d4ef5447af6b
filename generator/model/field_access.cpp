// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "field_access.hpp"

namespace oroforge::model {

const char* word(AccessKind kind) {
    switch (kind) {
        case AccessKind::Place: return "place";
        case AccessKind::Copy: return "copy";
        case AccessKind::Bytes: return "bytes";
        case AccessKind::Packed: return "packed";
        case AccessKind::EnumBits: return "enumBits";
        case AccessKind::Text: return "text";
        case AccessKind::Atomic: return "atomic";
        case AccessKind::Shared: return "shared";
        case AccessKind::Unique: return "unique";
        case AccessKind::Part: return "part";
        case AccessKind::Functions: return "functions";
        case AccessKind::Adapter: return "adapter";
    }
    return "";
}

}  // namespace oroforge::model
