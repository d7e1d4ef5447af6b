// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <messages/message_model.hpp>

#include <map>

#include <messages/identity.hpp>

namespace oroforge::messages {

namespace {

using model::TypeKind;
using model::TypeUse;

struct Builtin {
    TypeKind kind;
    const char* cpp;
    const char* name;  ///< in the type registry
};

/// The types that typekit ros-primitives registers.
const Builtin& builtin(const std::string& type) {
    static const std::map<std::string, Builtin> all = {
        {"bool", {TypeKind::Scalar, "std::uint8_t", "uint8"}},
        {"byte", {TypeKind::Scalar, "std::int8_t", "int8"}},
        {"char", {TypeKind::Scalar, "std::uint8_t", "uint8"}},
        {"int8", {TypeKind::Scalar, "std::int8_t", "int8"}},
        {"uint8", {TypeKind::Scalar, "std::uint8_t", "uint8"}},
        {"int16", {TypeKind::Scalar, "std::int16_t", "int16"}},
        {"uint16", {TypeKind::Scalar, "std::uint16_t", "uint16"}},
        {"int32", {TypeKind::Scalar, "std::int32_t", "int32"}},
        {"uint32", {TypeKind::Scalar, "std::uint32_t", "uint32"}},
        {"int64", {TypeKind::Scalar, "std::int64_t", "int64"}},
        {"uint64", {TypeKind::Scalar, "std::uint64_t", "uint64"}},
        {"float32", {TypeKind::Scalar, "float", "float32"}},
        {"float64", {TypeKind::Scalar, "double", "float64"}},
        {"string", {TypeKind::String, "std::string", "string"}},
        {"time", {TypeKind::Struct, "::ros::Time", "time"}},
        {"duration", {TypeKind::Struct, "::ros::Duration", "duration"}},
    };
    return all.at(type);
}

TypeUse useOf(const ValueType& type) {
    TypeUse use;
    if (type.isBuiltin) {
        const Builtin& known = builtin(type.name);
        use.kind = known.kind;
        use.cpp = known.cpp;
        use.name = known.name;
        use.array = std::string("c") + known.name + "[]";
        return use;
    }
    use.kind = TypeKind::Struct;
    use.cpp = cppOf(type.name);
    use.name = "/" + type.name;
    const std::size_t slash = use.name.rfind('/');
    use.array = use.name.substr(0, slash + 1) + "c" + use.name.substr(slash + 1) + "[]";
    return use;
}

TypeUse vectorOf(const TypeUse& element) {
    TypeUse use;
    use.kind = TypeKind::Sequence;
    use.cpp = "std::vector<" + element.cpp + ">";
    use.name = element.name + "[]";
    use.element = {element};
    return use;
}

model::Field fieldOf(const Field& field) {
    model::Field result;
    result.name = field.name;
    result.type = useOf(field.type);
    result.doc = field.doc;
    result.where = field.where;
    result.declared = result.type.cpp;
    if (field.extent == Extent::Any) {
        result.type = vectorOf(result.type);
        result.declared = result.type.cpp;
    } else if (field.extent == Extent::Fixed) {
        result.count = field.count;
        result.declared = "boost::array<" + result.type.cpp + ", " + std::to_string(field.count) + ">";
    }
    return result;
}

model::Proof proofOf(const Message& message, const MessageSet& set) {
    const std::string sum = md5Of(message, set);
    const std::string known = "ros::message_traits::MD5Sum<" + cppOf(message.fullName()) + ">::static_value";
    return {known + "1 == 0x" + sum.substr(0, 16) + "ULL && " + known + "2 == 0x" + sum.substr(16) + "ULL",
            "<" + message.fullName() + ".h> and the description of " + message.fullName() +
                " from which this file was made are of different versions; generate the headers of " + message.package +
                " and this file again"};
}

}  // namespace

std::string cppOf(const std::string& fullName) {
    const std::size_t slash = fullName.find('/');
    return "::" + fullName.substr(0, slash) + "::" + fullName.substr(slash + 1) + "_<std::allocator<void>>";
}

std::vector<model::Header> headersOf(const std::vector<std::string>& fullNames, const ModelRules& rules) {
    std::vector<model::Header> headers;
    for (std::size_t i = 0; i != fullNames.size(); ++i) {
        const std::string include = fullNames[i] + ".h";
        if (i % rules.perSource == 0) {
            headers.push_back({include, include, {}, 1, rules.includes});
        } else {
            headers.back().more.push_back(include);
        }
    }
    return headers;
}

model::TypeModel modelOf(const std::vector<const Message*>& messages, const MessageSet& set, const ModelRules& rules) {
    model::TypeModel model;
    std::vector<std::string> names;
    for (const Message* message : messages) names.push_back(message->fullName());
    model.headers = headersOf(names, rules);
    for (std::size_t i = 0; i != messages.size(); ++i) {
        const Message& message = *messages[i];
        const TypeUse use = useOf({message.fullName(), false});
        model::Struct type;
        type.cpp = use.cpp;
        type.name = use.name;
        type.homes = {{i / rules.perSource}};
        type.proof = proofOf(message, set);
        type.instances = rules.isForUsers;
        type.where = {message.file, 1, 1};
        for (const Field& field : message.fields)
            // An array of no elements has no bytes.
            if (field.extent != Extent::Fixed || field.count != 0) type.fields.push_back(fieldOf(field));
        model.structs.push_back(std::move(type));
        if (!rules.isForUsers) continue;
        model.library.push_back(vectorOf(use));
        model.arrays.push_back(use);
    }
    model.files = set.files();
    return model;
}

}  // namespace oroforge::messages
