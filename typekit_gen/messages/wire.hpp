// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What values of a type or a message consist of where they travel, in order: plain data that can be compared.
#ifndef OROFORGE_TYPEKIT_GEN_MESSAGES_WIRE_HPP
#define OROFORGE_TYPEKIT_GEN_MESSAGES_WIRE_HPP

#include <cstdint>
#include <string>
#include <vector>

#include <messages/message_set.hpp>
#include <model/type_model.hpp>

namespace oroforge::messages {

struct Wire {
    enum class Kind {
        Value,  ///< a number or a text, `word`
        Row,    ///< `count` times what `parts` says
        List,   ///< the same any number of times, behind the number
        None    ///< nothing that a message can hold; `word` says why
    };
    Kind kind = Kind::Value;
    std::string word;  ///< "float64"
    std::uint64_t count = 0;
    std::vector<Wire> parts;
    std::string path;      ///< the field: "position.x"
    diag::Location where;  ///< of the field of the outermost struct, or of the line in the .msg file
};

/// Of a struct of the model, without what is read only. Field names separated by dots.
std::vector<Wire> wireOf(const model::Struct& type, const model::TypeModel& model);

/// All parts of the message must be in the set.
std::vector<Wire> wireOf(const Message& message, const MessageSet& set);

}  // namespace oroforge::messages

#endif
