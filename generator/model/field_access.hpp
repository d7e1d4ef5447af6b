// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// How generated code reads and writes a field, or what is shown like one. Its C++ is in templates/typekit.
#ifndef OROFORGE_GENERATOR_MODEL_FIELD_ACCESS_HPP
#define OROFORGE_GENERATOR_MODEL_FIELD_ACCESS_HPP

#include <cstdint>
#include <string>

namespace oroforge::model {

enum class AccessKind {
    Place,      ///< it has an address, which its offset tells
    Copy,       ///< a member that must not be referred to, such as a bit-field
    Bytes,      ///< a member whose bytes are copied
    Packed,     ///< the same of one at an address that does not suit its type
    EnumBits,   ///< a bit-field of an enum without a name: shown as a number
    Text,       ///< an array of characters; the last one stays 0
    Atomic,     ///< a member of type std::atomic
    Shared,     ///< what a std::shared_ptr points to, or nothing
    Unique,     ///< the same of a std::unique_ptr
    Part,       ///< of a std::tuple
    Functions,  ///< two functions of its class
    Adapter     ///< words that the user wrote in an adapter
};

struct FieldAccess {
    AccessKind kind = AccessKind::Place;
    std::string get = {};      ///< name of a member or function, number of a Part; of an Adapter ".x()", "[index]"
    std::string set = {};      ///< the same to change it; empty: it is constant
    std::uint64_t number = 0;  ///< characters of a Text, offset in bytes of what is Packed
    std::string pointee = {};  ///< C++ type of what a pointer points to
    bool isAssigned = false;   ///< what is called to set it returns a reference, and takes no value
    bool hasAddress = false;   ///< to the value itself

    bool isPlace() const { return kind == AccessKind::Place; }
    bool isConstant() const { return !isPlace() && set.empty(); }
};

/// "enumBits" of AccessKind::EnumBits: the key in views and dumps.
const char* word(AccessKind kind);

}  // namespace oroforge::model

#endif
