// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/encoding/SchemaText.hpp>

#include <rtt/encoding/detail/encoder.hpp>
#include <rtt/encoding/detail/form_builder.hpp>
#include <rtt/encoding/detail/schema_model.hpp>

#include <exception>

namespace RTT::encoding {

namespace {

/** The units of all fields. What contains itself, or nests deeper than a reader wants to know, is left out. */
void addUnits(const detail::SchemaStruct& all, const std::string& path, unsigned depth, SchemaText& result) {
    constexpr unsigned kDeepest = 8;
    for (const detail::SchemaField& field : all.fields) {
        if (*field.unit != '\0') result.units.emplace_back(path + field.name, field.unit);
        if (field.type && depth != kDeepest) addUnits(*field.type, path + field.name + ".", depth + 1, result);
    }
}

}  // namespace

bool describeType(const types::TypeInfo& type, SchemaLanguage language, bool rosNames, SchemaText& result,
                  std::string& why) {
    const auto form = detail::buildForm(type, cdrRules(), detail::ReadOnly::LeftOut, why);
    if (!form) return false;
    result = {};
    detail::SchemaModel model(*form);
    detail::SchemaModel renamed(*form);
    if (rosNames) renamed.useRosNames();
    result.illegal = renamed.whyNotRos();
    if (language == SchemaLanguage::Ros2Msg && !result.illegal.empty()) {
        why = result.illegal;
        return false;
    }
    const bool isRos = language != SchemaLanguage::OmgIdl && result.illegal.empty();
    const detail::SchemaModel& chosen = isRos ? renamed : model;
    result.encoding = isRos ? "ros2msg" : "omgidl";
    result.name = isRos ? detail::rosName(chosen.root(), "/msg/") : detail::idlName(chosen.root());
    result.text = isRos ? detail::rosText(chosen) : detail::idlText(chosen);
    addUnits(chosen.root(), "", 0, result);
    return true;
}

namespace {

/** Empty if there is none. */
std::vector<unsigned char> defaultOf(const detail::Form& form) {
    std::vector<unsigned char> bytes;
    if (!form.shape.ops->construct) return bytes;
    try {
        const detail::Temporary value(*form.shape.ops);
        detail::ByteCount count;
        if (!detail::Encoder<detail::ByteCount>(count, cdrRules()).put(form, value.at())) return bytes;
        bytes.resize(count.position());
        detail::ByteWriter writer(bytes.data(), bytes.size());
        if (!detail::Encoder<detail::ByteWriter>(writer, cdrRules()).put(form, value.at())) bytes.clear();
    } catch (const std::exception&) {  // by a function of the type
        bytes.clear();
    }
    return bytes;
}

}  // namespace

std::map<std::string, std::vector<unsigned char>> describeDefaults(const types::TypeInfo& type,
                                                                   const SchemaText& description) {
    std::map<std::string, std::vector<unsigned char>> result;
    std::string why;
    const auto form = detail::buildForm(type, cdrRules(), detail::ReadOnly::LeftOut, why);
    if (!form) return result;
    const detail::SchemaModel model(*form);
    for (const auto& [part, its] : model.forms()) {
        std::vector<unsigned char> bytes = defaultOf(*part);
        if (bytes.empty()) continue;
        if (its == &model.root()) result[""] = bytes;
        result[description.encoding == "ros2msg" ? detail::rosName(*its, "/") : detail::idlName(*its)] =
            std::move(bytes);
    }
    return result;
}

}  // namespace RTT::encoding
