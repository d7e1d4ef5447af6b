// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <merge/record.hpp>

#include <nlohmann/json.hpp>

#include <merge/text_places.hpp>

namespace oroforge::merge {

namespace {

using nlohmann::json;

constexpr int kFormat = 1;
const char* const kAbout =
    "what orocreate-pkg last wrote into the classes of this package; orocreate-pkg --update needs it";

json toJson(const Registration& registration) {
    json value{{"how", registration.how}};
    for (const DocText& text : registration.texts) {
        if (text.argument.empty()) {
            value["doc"] = text.words;
        } else {
            value["arguments"].push_back({text.argument, text.words});
        }
    }
    return value;
}

json toJson(const RecordedMethod& method) {
    json value{{"returns", method.signature.returns}, {"arguments", json::array()}};
    for (const model::TypedName& argument : method.signature.arguments)
        value["arguments"].push_back(argument.type + " " + argument.name);
    if (method.isHook) value["hook"] = true;
    if (method.kept) value["kept"] = true;
    if (method.registration) value["registration"] = toJson(*method.registration);
    return value;
}

json toJson(const RecordedMember& member) {
    json value{{"kind", member.kind}, {"member", member.member}, {"type", member.type}};
    if (member.kept) value["kept"] = true;
    if (!member.portClass.empty()) value["port"] = member.portClass;
    if (member.registration) value["registration"] = toJson(*member.registration);
    return value;
}

std::optional<Registration> registrationFrom(const json& owner) {
    if (!owner.contains("registration")) return std::nullopt;
    const json& value = owner["registration"];
    Registration registration{value.at("how").get<std::string>(), {}};
    if (value.contains("doc")) registration.texts.push_back({"", value["doc"].get<std::string>()});
    for (const json& one : value.value("arguments", json::array()))
        registration.texts.push_back({one.at(0).get<std::string>(), one.at(1).get<std::string>()});
    return registration;
}

RecordedMethod methodFrom(const json& value) {
    RecordedMethod method;
    method.signature.returns = value.at("returns").get<std::string>();
    for (const json& argument : value.at("arguments"))
        method.signature.arguments.push_back(splitTyped(argument.get<std::string>()));
    method.isHook = value.value("hook", false);
    method.kept = value.value("kept", false);
    method.registration = registrationFrom(value);
    return method;
}

RecordedMember memberFrom(const json& value) {
    return {value.at("kind").get<std::string>(), value.at("member").get<std::string>(),
            value.at("type").get<std::string>(), value.value("kept", false),
            value.value("port", std::string()),  registrationFrom(value)};
}

}  // namespace

std::string toText(const Record& record) {
    json all{{"about", kAbout}, {"format", kFormat}, {"classes", json::object()}};
    for (const auto& [name, one] : record) {
        json value{{"methods", json::object()}};
        for (const auto& [method, what] : one.methods) value["methods"][method] = toJson(what);
        for (const auto& [member, what] : one.members) value["members"][member] = toJson(what);
        all["classes"][name] = value;
    }
    return all.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

std::optional<Record> parseRecord(const std::string& text, const std::string& file, diag::Sink& sink) {
    try {
        const json all = json::parse(text);
        if (all.at("format").get<int>() > kFormat) {
            sink.error({file, 0, 0}, "OC039", "the record was written by a newer orocreate-pkg");
            return std::nullopt;
        }
        Record record;
        for (const auto& [name, value] : all.at("classes").items()) {
            RecordedClass& one = record[name];
            for (const auto& [method, what] : value.at("methods").items()) one.methods[method] = methodFrom(what);
            if (!value.contains("members")) continue;
            for (const auto& [member, what] : value.at("members").items()) one.members[member] = memberFrom(what);
        }
        return record;
    } catch (const json::exception& error) {
        sink.error({file, 0, 0}, "OC039",
                   "the record of what was generated cannot be read: " + std::string(error.what()))
            .hint("take it from version control, or remove it: then each difference is asked for");
        return std::nullopt;
    }
}

}  // namespace oroforge::merge
