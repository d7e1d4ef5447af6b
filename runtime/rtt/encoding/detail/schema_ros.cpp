// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Message files of ROS 2.
#include <rtt/encoding/detail/schema_model.hpp>

#include <cctype>
#include <set>

namespace RTT::encoding::detail {

using types::Shape;

namespace {

const char* rosType(Shape::Number number) {
    switch (number) {
        case Shape::Number::Bool: return "bool";
        case Shape::Number::Float32: return "float32";
        case Shape::Number::Float64: return "float64";
        default: return sharedNameOf(number);
    }
}

std::string typeOf(const SchemaField& field) {
    if (field.type) return rosName(*field.type, "/");
    return field.basic->shape.kind == Shape::Kind::Text ? "string" : rosType(numberOf(*field.basic));
}

std::string lineEnd(const std::string& comment) { return comment.empty() ? "\n" : "  # " + comment + "\n"; }

/** Constants right above a field are what viewers take for the names of its values. */
void addConstants(std::string& out, const SchemaField& field, std::set<std::string>& names) {
    if (!field.basic || field.basic->shape.kind != Shape::Kind::Enumeration || field.basic->hasBool) return;
    for (const Shape::Enumerator& one : field.basic->shape.enumerators) {
        std::string name = snakeCase(field.name + "_" + one.name);
        for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        if (!names.insert(name).second) continue;
        out += typeOf(field) + " " + name + "=" + valueText(one, *field.basic) + lineEnd(oneLine(one.doc));
    }
}

std::string fieldsOf(const SchemaStruct& one) {
    std::string out;
    std::set<std::string> constants;
    for (const SchemaField& field : one.fields) {
        addConstants(out, field, constants);
        out += typeOf(field);
        if (field.isSequence) out += "[]";
        if (field.count != 0) out += "[" + std::to_string(field.count) + "]";
        out += " " + field.name + lineEnd(commentOf(field));
    }
    if (one.hasByte) out += std::string("uint8 ") + kEmptyField + "\n";
    return out;
}

}  // namespace

bool isRosName(const std::string& name) {
    bool isGood = !name.empty() && std::islower(static_cast<unsigned char>(name[0])) != 0 && name.back() != '_';
    for (std::size_t i = 0; i != name.size(); ++i) {
        const auto c = static_cast<unsigned char>(name[i]);
        isGood = isGood && (std::islower(c) != 0 || std::isdigit(c) != 0 || (c == '_' && name[i + 1] != '_'));
    }
    return isGood;
}

std::string rosName(const SchemaStruct& one, const char* separator) {
    std::string package;
    for (const std::string& part : one.path) package += (package.empty() ? "" : "_") + part;
    return package + separator + one.name;
}

std::string rosText(const SchemaModel& model) {
    std::string out = fieldsOf(model.root());
    for (const SchemaStruct* one : model.structs()) {
        if (one == &model.root()) continue;
        out += std::string(80, '=') + "\nMSG: " + rosName(*one, "/") + "\n" + fieldsOf(*one);
    }
    return out;
}

}  // namespace RTT::encoding::detail
