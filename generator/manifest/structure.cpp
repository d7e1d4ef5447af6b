// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <manifest/schema.hpp>

#include <algorithm>

#include <diag/nearest_match.hpp>
#include <model/literal.hpp>

namespace oroforge::manifest {

namespace {

template <class Rules>
std::vector<std::string> namesOf(const Rules& rules) {
    std::vector<std::string> names;
    for (const auto& rule : rules) names.push_back(rule.name);
    return names;
}

template <class Rules>
auto findRule(const Rules& rules, const std::string& name) {
    return std::find_if(rules.begin(), rules.end(), [&](const auto& rule) { return rule.name == name; });
}

std::string expected(const AttributeRule& rule) {
    switch (rule.kind) {
        case ValueKind::Boolean: return "expected 'true' or 'false'";
        case ValueKind::Integer: return "expected a whole number";
        case ValueKind::Number: return "expected a number such as '0.01'";
        case ValueKind::Choice: return "expected " + diag::oneOf(rule.choices);
        case ValueKind::Text: break;
    }
    return "expected a text";
}

void checkValue(const AttributeRule& rule, const xml::Attribute& attribute, diag::Sink& sink) {
    const std::string found = "attribute '" + attribute.name + "' has the value '" + attribute.value + "', ";
    if (rule.kind == ValueKind::Choice) {
        if (std::find(rule.choices.begin(), rule.choices.end(), attribute.value) != rule.choices.end()) return;
        sink.error(attribute.valueWhere, "OM004",
                   found + expected(rule) + diag::didYouMean(attribute.value, rule.choices));
    } else if (!isWellFormed(rule.kind, attribute.value)) {
        sink.error(attribute.valueWhere, "OM005", found + expected(rule));
    }
}

void checkAttributes(const xml::Element& element, const ElementRule& rule, diag::Sink& sink) {
    for (const xml::Attribute& attribute : element.attributes) {
        const auto known = findRule(rule.attributes, attribute.name);
        if (known != rule.attributes.end()) {
            checkValue(*known, attribute, sink);
        } else if (attribute.name.str().compare(0, 5, "xmlns") != 0 &&
                   attribute.name.str().compare(0, 4, "xsi:") != 0) {
            sink.error(attribute.where, "OM002",
                       "<" + element.name + "> has no attribute '" + attribute.name + "'" +
                           diag::didYouMean(attribute.name, namesOf(rule.attributes)));
        }
    }
    for (const AttributeRule& wanted : rule.attributes) {
        if (wanted.required && !element.hasAttribute(wanted.name)) {
            sink.error(element.where, "OM003", "<" + element.name + "> needs the attribute '" + wanted.name + "'");
        }
    }
}

void checkChildren(const xml::Element& element, const ElementRule& rule, diag::Sink& sink) {
    for (const xml::Element& child : element.children) {
        const auto known = findRule(rule.children, child.name);
        if (known == rule.children.end()) {
            sink.error(child.where, "OM001",
                       "<" + element.name + "> cannot contain <" + child.name + ">" +
                           diag::didYouMean(child.name, namesOf(rule.children)));
            continue;
        }
        const xml::Element* first = element.child(child.name);
        if (!known->repeatable && first != &child) {
            sink.error(child.where, "OM008", "<" + element.name + "> can have only one <" + child.name + ">")
                .note(first->where, "the first is here");
        }
        checkStructure(child, sink);
    }
}

}  // namespace

bool isWellFormed(ValueKind kind, const std::string& value) {
    switch (kind) {
        case ValueKind::Boolean: return model::isBooleanText(value);
        case ValueKind::Integer: return model::isIntegerText(value);
        case ValueKind::Number: return model::isNumberText(value);
        case ValueKind::Text:
        case ValueKind::Choice: break;
    }
    return true;
}

void checkStructure(const xml::Element& element, diag::Sink& sink) {
    const ElementRule* rule = ruleFor(element.name);
    if (rule == nullptr) return;
    checkAttributes(element, *rule, sink);
    checkChildren(element, *rule, sink);
    if (!rule->hasText && !element.text.empty()) {
        sink.error(element.textWhere, "OM007",
                   "<" + element.name + "> contains text; its content goes into attributes and child elements");
    }
    if (element.name != "doc" && element.hasAttribute("doc") && element.child("doc") != nullptr) {
        sink.error(element.child("doc")->where, "OM008", "<" + element.name + "> has its documentation twice")
            .note(element.attribute("doc")->where, "given here as an attribute");
    }
}

}  // namespace oroforge::manifest
