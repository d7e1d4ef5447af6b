// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// How generated code reads and writes a field, or a part shown as a field. templates/typekit has the C++ for it.
#ifndef OROFORGE_GENERATOR_MODEL_FIELD_ACCESS_HPP
#define OROFORGE_GENERATOR_MODEL_FIELD_ACCESS_HPP

#include <cstdint>
#include <string>

namespace oroforge::model {

enum class AccessKind {
    Place,      ///< it has an address, given by its offset
    Copy,       ///< a member that no reference can bind to, such as a bit-field
    Bytes,      ///< a member whose bytes are copied
    Packed,     ///< the same for a member that is not aligned for its type
    EnumBits,   ///< a bit-field of an enum without a name: shown as a number
    Text,       ///< an array of characters; the last one stays 0
    Atomic,     ///< a std::atomic
    Shared,     ///< the pointee of a std::shared_ptr, or nothing
    Unique,     ///< the same for a std::unique_ptr
    Part,       ///< an element of a std::tuple
    Functions,  ///< two member functions
    Adapter     ///< text that the user wrote in an adapter
};

struct FieldAccess {
    AccessKind kind = AccessKind::Place;
    std::string get = {};      ///< name of a member or function, number of a Part; ".x()" or "[index]" of an Adapter
    std::string set = {};      ///< the same for writing; empty: constant
    std::uint64_t number = 0;  ///< characters of a Text, offset in bytes of a Packed member
    std::string pointee = {};  ///< C++ type of a pointer's target
    bool isAssigned = false;   ///< the setter returns a reference that is assigned to, and takes no value
    bool hasAddress = false;   ///< the value itself has an address

    bool isPlace() const { return kind == AccessKind::Place; }
    bool isConstant() const { return !isPlace() && set.empty(); }
};

/// Returns the key in views and dumps: "enumBits" for AccessKind::EnumBits.
const char* word(AccessKind kind);

}  // namespace oroforge::model

#endif
