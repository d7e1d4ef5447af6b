// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The elements and attributes that a manifest may have, and the form of their values.
#ifndef OROFORGE_GENERATOR_MANIFEST_SCHEMA_HPP
#define OROFORGE_GENERATOR_MANIFEST_SCHEMA_HPP

#include <string>
#include <vector>

#include <xml/element.hpp>

namespace oroforge::manifest {

enum class ValueKind { Text, Boolean, Number, Integer, Choice };

struct AttributeRule {
    std::string name;
    bool required = false;
    ValueKind kind = ValueKind::Text;
    std::vector<std::string> choices;
};

struct ChildRule {
    std::string name;
    bool repeatable = false;
};

struct ElementRule {
    std::string name;
    std::vector<AttributeRule> attributes;
    std::vector<ChildRule> children;
    bool hasText = false;
};

/// Returns the rules of all elements, the root's first.
const std::vector<ElementRule>& allRules();

/// Returns the same as XML Schema (XSD 1.0), without the rules that it cannot express.
std::string schemaText();

/// Returns null for an unknown element.
const ElementRule* ruleFor(const std::string& element);

/// Reports whatever the rules do not allow in `element` and below: unknown elements and attributes with the nearest
/// known name, missing attributes, malformed values, misplaced text (codes OM001 to OM008).
void checkStructure(const xml::Element& element, diag::Sink& sink);

/// True if `value` has the form of `kind`; any text is a Text.
bool isWellFormed(ValueKind kind, const std::string& value);

}  // namespace oroforge::manifest

#endif
