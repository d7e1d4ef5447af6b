// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_REPLAY_TYPE_DIFFERENCE_HPP
#define OROFORGE_REPLAY_TYPE_DIFFERENCE_HPP

#include <reporting/schema/message_schema.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace OCL::replay {

/** Do the values of two fields have the same bytes, but for what is different in their structs? */
bool isSameKind(const oroforge::schema::Field& a, const oroforge::schema::Field& b);

/** "float64[3]", "string[]", "tank::Level" */
std::string kindOf(const oroforge::schema::Field& field);

/** How a loaded type differs from the recorded one. */
struct TypeDifference {
    std::vector<std::string> fields;  ///< a sentence for each field that differs, in the order of the loaded type
    bool sharesField = false;         ///< at least one field of the message is in both

    explicit operator bool() const { return !fields.empty(); }
    /** The first ones, in a row. */
    std::string text() const;
};

TypeDifference compareTypes(const oroforge::schema::MessageSchema& recorded,
                            const oroforge::schema::MessageSchema& loaded);

}  // namespace OCL::replay

#endif
