// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "read_value.hpp"
#include "xml_to_plan.hpp"

#include <cpf/cpf_reader.hpp>

#include <diag/nearest_match.hpp>

#include <algorithm>

namespace OCL::deploy {
namespace {

// The attributes in the DTD of property files. Most have no effect, in the original or here.
const std::vector<std::string> kAttributes = {"name", "type", "mode", "id"};
const std::vector<std::string> kPartsOfSimple = {"value", "description",  "choices", "range",
                                                 "kind",  "enumerations", "units",   "defaultvalue"};

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool isOfOtherNamespace(const std::string& name) { return name.find(':') != std::string::npos || name == "xmlns"; }

void checkAttributes(const xml::Element& element, diag::Sink& sink) {
    for (const xml::Attribute& attribute : element.attributes)
        if (!contains(kAttributes, attribute.name) && !isOfOtherNamespace(attribute.name))
            sink.warning(attribute.where, "DEP061",
                         "attribute '" + attribute.name + "' of <" + element.name + "> has no effect" +
                             diag::didYouMean(attribute.name, {"name", "type"}));
}

void checkSimple(const xml::Element& element, diag::Sink& sink) {
    const xml::Element* value = nullptr;
    for (const xml::Element& child : element.children) {
        if (!contains(kPartsOfSimple, child.name))
            sink.warning(child.where, "DEP061",
                         "<" + child.name + "> in <simple> has no effect" +
                             diag::didYouMean(child.name, {"value", "description"}));
        if (child.name != "value") continue;
        if (value)
            sink.warning(child.where, "DEP061", "a second <value> has no effect")
                .note(value->where, "the first is here");
        else
            value = &child;
        if (!child.children.empty())
            sink.warning(child.children.front().where, "DEP061",
                         "<" + child.children.front().name + "> in <value> has no effect");
    }
}

}  // namespace

void checkText(const xml::Element& element, diag::Sink& sink) {
    if (element.text.find_first_not_of(" \t\r\n") != std::string::npos)
        RTT::marsh::reportStrayText(element, "DEP062", sink);
}

void checkForm(const xml::Element& element, diag::Sink& sink) {
    if (element.name != "simple" && element.name != "struct" && element.name != "sequence") return;
    checkAttributes(element, sink);
    checkText(element, sink);
    if (element.name == "simple") return checkSimple(element, sink);
    for (const xml::Element& child : element.children) checkForm(child, sink);
}

}  // namespace OCL::deploy
