// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "foxglove_service.hpp"

#include "oro_messages.hpp"

#include <rtt/encoding/Json.hpp>
#include <rtt/types/Types.hpp>

#include <algorithm>

namespace OCL::live {
namespace {

using nlohmann::json;

/** Foxglove refuses a service with a field that has no type: what cannot be described is a text, which oro.call reads,
    too. */
json schemaOf(const std::string& type) {
    const RTT::types::TypeInfo* const info = RTT::types::Types()->type(type);
    std::string why;
    const auto form = info ? RTT::encoding::Json::make(*info, why) : nullptr;
    const std::string text = form ? form->schema() : std::string();
    return text.empty() ? json{{"type", "string"}} : json::parse(text);
}

json described(const json& argument) {
    const std::string type = argument.value("type", ""), doc = argument.value("doc", "");
    json schema = schemaOf(type);
    schema["description"] = doc.empty() ? type : type + ": " + doc;
    return schema;
}

json messageForm(const std::string& name, const std::string& schema) {
    return {{"encoding", "json"}, {"schemaName", name}, {"schemaEncoding", "jsonschema"}, {"schema", schema}};
}

std::string objectOf(const json& properties) { return textOf({{"type", "object"}, {"properties", properties}}); }

}  // namespace

json foxgloveService(std::uint32_t id, const std::string& name, const std::string& type, const json& operation) {
    json arguments = json::object(), results = json::object();
    const std::string result = operation.value("result", "void");
    if (result != "void") results["result"] = schemaOf(result);
    for (const json& argument : operation.value("arguments", json::array())) {
        const std::string own = argument.value("name", "");
        arguments[own] = described(argument);
        if (argument.value("output", false)) results[own] = arguments[own];
    }
    const std::string request = objectOf(arguments), response = objectOf(results);
    return {{"id", id},
            {"name", name},
            {"type", type},
            {"request", messageForm(type + "_Request", request)},
            {"response", messageForm(type + "_Response", response)},
            // For clients of foxglove.websocket.v1.
            {"requestSchema", request},
            {"responseSchema", response}};
}

json foxgloveArguments(const std::vector<std::string>& names, const json& request, std::string& why) {
    json arguments = json::array();
    for (const std::string& name : names) {
        const auto given = request.find(name);
        if (given == request.end()) {
            why = "argument '" + name + "' is missing";
            return nullptr;
        }
        arguments.push_back(*given);
    }
    for (const auto& [name, value] : request.items())
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            why = "there is no argument '" + name + "'";
            return nullptr;
        }
    return arguments;
}

json foxgloveResult(const json& result) {
    json made = json::object();
    if (result.value("type", "void") != "void") made["result"] = result.value("value", json());
    for (const json& argument : result.value("arguments", json::array()))
        made[argument.value("name", "")] = argument.value("value", json());
    return made;
}

}  // namespace OCL::live
