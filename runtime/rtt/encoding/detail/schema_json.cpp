// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/encoding/detail/schema_json.hpp>

#include <string>
#include <vector>

namespace RTT::encoding::detail {

using nlohmann::json;
using types::Shape;

namespace {

class SchemaWriter {
public:
    json describe(const Form& form) {
        switch (form.shape.kind) {
            case Shape::Kind::Number: return number(form.shape.number);
            case Shape::Kind::Enumeration: return enumeration(form);
            case Shape::Kind::Text: return {{"type", "string"}};
            case Shape::Kind::Struct: return object(form);
            case Shape::Kind::Sequence: return array(*form.element);
            case Shape::Kind::Shown: return describe(*form.shown);
            case Shape::Kind::Variant:
            case Shape::Kind::None: break;
        }
        return nullptr;
    }

private:
    static json number(Shape::Number number) {
        switch (number) {
            case Shape::Number::Bool: return {{"type", "boolean"}};
            case Shape::Number::Char: return {{"type", "string"}};
            case Shape::Number::Float32:
            case Shape::Number::Float64: return {{"type", "number"}};
            default: return {{"type", "integer"}};
        }
    }

    static json enumeration(const Form& form) {
        json names = json::array();
        for (const Shape::Enumerator& one : form.shape.enumerators) names.push_back(one.name);
        return {{"type", "string"}, {"enum", std::move(names)}};
    }

    json array(const Form& element) {
        json items = describe(element);
        if (items.is_null() || items["type"] == "array") return nullptr;
        return {{"type", "array"}, {"items", std::move(items)}};
    }

    json object(const Form& form) {
        for (const Form* const outer : outer_)
            if (outer == &form) return nullptr;  // it contains itself
        outer_.push_back(&form);
        json properties = json::object();
        for (const FormField& field : form.fields) {
            json described = field.count == 0 ? describe(*field.form) : array(*field.form);
            if (described.is_null()) continue;
            std::string doc = field.doc;
            if (*field.unit != '\0') doc += (doc.empty() ? "[" : " [") + std::string(field.unit) + "]";
            if (!doc.empty()) described["description"] = doc;
            properties[field.name] = std::move(described);
        }
        outer_.pop_back();
        return {{"type", "object"}, {"properties", std::move(properties)}};
    }

    std::vector<const Form*> outer_;
};

}  // namespace

json jsonSchema(const Form& form) { return SchemaWriter().describe(form); }

}  // namespace RTT::encoding::detail
