// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Which elements and attributes a manifest may have, and what their values look like.
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

/// The rules of all elements, that of the root first.
const std::vector<ElementRule>& allRules();

/// The same as XML Schema (XSD 1.0), less what that cannot say.
std::string schemaText();

/// Null for an unknown element.
const ElementRule* ruleFor(const std::string& element);

/// Reports everything in `element` and below that the rules do not allow: unknown elements and attributes with the
/// nearest known name, missing attributes, malformed values, text where none belongs (codes OM001 to OM008).
void checkStructure(const xml::Element& element, diag::Sink& sink);

/// True if `value` is written as `kind` wants it; texts always are.
bool isWellFormed(ValueKind kind, const std::string& value);

}  // namespace oroforge::manifest

#endif
