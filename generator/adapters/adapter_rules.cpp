// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "adapter_rules.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <diag/nearest_match.hpp>

namespace oroforge::adapters {

namespace {

using Names = std::vector<std::string>;

struct Rule {
    const char* element;
    Names required;
    Names optional;
    Names children;
};

const std::vector<Rule>& rules() {
    static const std::vector<Rule> all = {
        {"adapters", {}, {}, {"struct", "sequence", "matrix"}},
        {"struct", {"class"}, {"arguments", "name", "alias", "doc", "initial"}, {"member", "constructor"}},
        {"member", {"name", "get"}, {"also", "set", "doc", "unit", "range"}, {}},
        {"sequence",
         {"class", "size", "element"},
         {"arguments", "name", "alias", "doc", "initial", "resize", "set"},
         {"constructor"}},
        {"matrix",
         {"class", "rows", "columns", "element"},
         {"arguments", "name", "alias", "doc", "initial", "resize", "set"},
         {"constructor"}},
        {"constructor", {"arguments"}, {"call"}, {}},
    };
    return all;
}

const Rule* ruleFor(const std::string& element) {
    const auto found =
        std::find_if(rules().begin(), rules().end(), [&](const Rule& rule) { return element == rule.element; });
    return found == rules().end() ? nullptr : &*found;
}

bool has(const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

void checkAttributes(const xml::Element& element, const Rule& rule, diag::Sink& sink) {
    Names known = rule.required;
    known.insert(known.end(), rule.optional.begin(), rule.optional.end());
    for (const xml::Attribute& attribute : element.attributes) {
        if (!has(known, attribute.name)) {
            sink.error(attribute.where, "TK070",
                       "<" + element.name + "> has no attribute '" + attribute.name + "'" +
                           diag::didYouMean(attribute.name, known));
        } else if (attribute.value.empty() && attribute.name != "doc") {
            sink.error(attribute.where, "TK070", "attribute '" + attribute.name + "' is empty");
        }
    }
    for (const std::string& name : rule.required) {
        if (!element.hasAttribute(name))
            sink.error(element.where, "TK070", "<" + element.name + "> needs the attribute '" + name + "'");
    }
}

void check(const xml::Element& element, const Rule& rule, diag::Sink& sink) {
    checkAttributes(element, rule, sink);
    if (!element.text.empty())
        sink.error(element.textWhere, "TK070", "<" + element.name + "> contains text, expected attributes only");
    for (const xml::Element& child : element.children) {
        if (has(rule.children, child.name)) {
            check(child, *ruleFor(child.name), sink);
            continue;
        }
        sink.error(
            child.where, "TK070",
            "<" + element.name + "> cannot contain <" + child.name + ">" + diag::didYouMean(child.name, rule.children));
    }
}

}  // namespace

bool checkStructure(const xml::Element& root, diag::Sink& sink) {
    const std::size_t before = sink.errorCount();
    if (root.name == "adapters") {
        check(root, rules().front(), sink);
    } else {
        sink.error(root.where, "TK070",
                   "root element <" + root.name + ">, expected <adapters>" + diag::didYouMean(root.name, {"adapters"}));
    }
    return sink.errorCount() == before;
}

}  // namespace oroforge::adapters
