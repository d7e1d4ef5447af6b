// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ENCODING_SCHEMA_TEXT_HPP
#define ORO_ENCODING_SCHEMA_TEXT_HPP

#include <rtt/rtt-config.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace RTT {
namespace types {
class TypeInfo;
}

namespace encoding {

/** Languages in which files and transports describe a type to programs that do not know it. */
enum class SchemaLanguage {
    Auto,     ///< Ros2Msg if all names of the type are legal there, otherwise OmgIdl
    Ros2Msg,  ///< message files of ROS 2, of all types one after another
    OmgIdl    ///< IDL of OMG
};

/** The text that describes the bytes of a Plan with cdrRules(). */
struct RTT_API SchemaText {
    std::string name;      ///< "tank/msg/Level", or "tank::Level" in IDL
    std::string encoding;  ///< "ros2msg" or "omgidl"
    std::string text;
    std::vector<std::pair<std::string, std::string>> units;  ///< of fields: "pose.angle", "rad"
    std::string illegal;                                     ///< with Auto and OmgIdl: why it is not Ros2Msg, or empty
};

/**
 * Describes a type. Fields have their descriptions and units as comments; enumerators are constants. What a message
 * cannot be by itself, such as a number or a sequence, becomes the field `data` of one: numbers and texts are those of
 * std_msgs. A sequence of sequences is one of structs with a field `data`. None of this changes the bytes.
 *
 * With `rosNames`, Ros2Msg has names that are legal there instead of those of the type: `angle_rad` for `angleRad`.
 *
 * False, with the reason in `why`, if the type has no shape, or Ros2Msg is asked for and cannot describe it. Allocates.
 */
RTT_API bool describeType(const types::TypeInfo& type, SchemaLanguage language, bool rosNames, SchemaText& result,
                          std::string& why);

/**
 * The bytes, as those of a Plan with cdrRules(), of default values of all structs that such a description has, by their
 * names there: "tank/Level", or "tank::Level" in IDL. That of the type itself is also under the name "". Without those
 * that have no default value. Allocates.
 */
RTT_API std::map<std::string, std::vector<unsigned char>> describeDefaults(const types::TypeInfo& type,
                                                                           const SchemaText& description);

}  // namespace encoding
}  // namespace RTT

#endif
