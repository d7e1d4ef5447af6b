// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/encoding/Json.hpp>

#include <rtt/encoding/detail/form_builder.hpp>
#include <rtt/encoding/detail/json_reader.hpp>
#include <rtt/encoding/detail/json_writer.hpp>
#include <rtt/encoding/detail/schema_json.hpp>

#include <nlohmann/json.hpp>

#include <exception>
#include <utility>

namespace RTT::encoding {

std::shared_ptr<const Json> Json::make(const types::TypeInfo& type, std::string& why) {
    std::shared_ptr<const detail::Form> form = detail::buildForm(type, cdrRules(), detail::ReadOnly::Kept, why);
    return form ? std::shared_ptr<const Json>(new Json(std::move(form))) : nullptr;
}

Json::Json(std::shared_ptr<const detail::Form> form) : form_(std::move(form)) {}
Json::~Json() = default;

std::string Json::text(const void* value) const {
    std::string out;
    detail::JsonWriter(out).put(*form_, value);
    return out;
}

std::string Json::parse(std::string_view text, void* value) const {
    nlohmann::json from;
    try {
        from = nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& error) {
        return "byte " + std::to_string(error.byte) + ": the text is no JSON";
    } catch (const nlohmann::json::exception&) {  // a number that no double holds
        return "the text has a number that is too large";
    }
    detail::JsonReader reader;
    try {
        (void)reader.get(*form_, from, value);
    } catch (const std::exception& thrown) {  // by a container, or a function of the type
        return std::string("the type refuses the value: ") + thrown.what();
    }
    return reader.error();
}

std::string Json::schema() const {
    const nlohmann::json described = detail::jsonSchema(*form_);
    return described.is_null() ? std::string()
                               : described.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace RTT::encoding
