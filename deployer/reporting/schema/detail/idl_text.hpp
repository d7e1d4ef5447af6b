// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_SCHEMA_IDL_TEXT_HPP
#define OROFORGE_SCHEMA_IDL_TEXT_HPP

#include "../message_schema.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace oroforge::schema {

/** Reads IDL of OMG, as far as it describes data: modules, structs with bases, unions, enums, constants and typedefs of
    basic types, texts, sequences and arrays. `root` becomes the index of the struct with this name. False, with the
    reason and the line, if the text is not valid, or a message cannot be read by it. */
bool readIdl(const std::string& text, const std::string& name, std::vector<Struct>& structs, std::size_t& root,
             std::string& why);

}  // namespace oroforge::schema

#endif
