// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <xml/element.hpp>

#include <algorithm>

namespace oroforge::xml {

namespace {

template <class Range>
auto* findNamed(Range& range, const std::string& name) {
    const auto found = std::find_if(range.begin(), range.end(), [&](const auto& item) { return item.name == name; });
    return found == range.end() ? nullptr : &*found;
}

}  // namespace

const Attribute* Element::attribute(const std::string& wanted) const { return findNamed(attributes, wanted); }

std::string Element::attributeOr(const std::string& wanted, const std::string& fallback) const {
    const Attribute* found = attribute(wanted);
    return found != nullptr ? found->value : fallback;
}

const Attribute* Element::requireAttribute(const std::string& wanted, diag::Sink& sink) const {
    const Attribute* found = attribute(wanted);
    if (found == nullptr) sink.error(where, "XML010", "<" + name + "> has no attribute '" + wanted + "'");
    return found;
}

const Element* Element::child(const std::string& wanted) const { return findNamed(children, wanted); }

std::vector<const Element*> Element::childrenNamed(const std::string& wanted) const {
    std::vector<const Element*> found;
    for (const Element& candidate : children) {
        if (candidate.name == wanted) found.push_back(&candidate);
    }
    return found;
}

}  // namespace oroforge::xml
