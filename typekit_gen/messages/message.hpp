// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What a .msg or .srv file says: plain data.
#ifndef OROFORGE_TYPEKIT_GEN_MESSAGES_MESSAGE_HPP
#define OROFORGE_TYPEKIT_GEN_MESSAGES_MESSAGE_HPP

#include <cstdint>
#include <string>
#include <vector>

#include <diag/diagnostic.hpp>

namespace oroforge::messages {

/// The type of one value: "bool", "float64", "string", "time", or "pkg/Msg" of another message.
struct ValueType {
    std::string name;
    bool isBuiltin = true;
};

enum class Extent { Single, Fixed, Any };

struct Field {
    ValueType type;
    Extent extent = Extent::Single;
    std::uint64_t count = 0;  ///< elements of a Fixed array
    std::string written;      ///< the type as md5 sums have it: "float64[9]"
    std::string name;
    std::string doc;  ///< comment behind it, or else directly above, in one line
    diag::Location where;
};

struct Constant {
    std::string type;
    std::string name;
    std::string value;  ///< as written, without spaces around it
    diag::Location where;
};

struct Message {
    std::string package;
    std::string name;  ///< "Pose"; "SetBoolRequest" for one half of a service
    std::vector<Field> fields;
    std::vector<Constant> constants;
    std::string text;  ///< the whole file, or half of it, with "\n" at the ends of lines
    std::string file;

    std::string fullName() const { return package + "/" + name; }
};

struct Service {
    std::string package;
    std::string name;
    Message request;
    Message response;
    std::string file;
};

/// One of the 14 types that need no file.
bool isBuiltin(const std::string& type);

}  // namespace oroforge::messages

#endif
