// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "cpf_edit.hpp"

#include "cpf_values.hpp"
#include "cpf_writer.hpp"
#include "text_edit.hpp"

#include <rtt/internal/values/property_update.hpp>
#include <rtt/types/Types.hpp>

#include <xml/escape.hpp>

#include <algorithm>
#include <iterator>
#include <memory>
#include <vector>

namespace RTT::marsh {

namespace xml = oroforge::xml;
using base::PropertyBase;
using internal::detail::bagOf;
using internal::detail::NamePairing;

namespace {

typedef std::vector<const xml::Element*> Elements;

bool isBag(const xml::Element& element) { return element.name == "struct" || element.name == "sequence"; }

/** Collects the properties in `parent`, also those inside elements that mean nothing to the reader. */
void findProperties(const xml::Element& parent, Elements& found) {
    for (const auto& child : parent.children) {
        if (child.name == "simple" || isBag(child))
            found.push_back(&child);
        else if (child.name != "description")
            findProperties(child, found);
    }
}

bool isPlain(const std::string& type) { return type.empty() || type == "PropertyBag" || type == "type_less"; }

/** True for the elements of a sequence or array: their order counts, their names do not. */
bool areElements(const PropertyBag& bag) {
    if (isPlain(bag.getType())) return false;
    return isSequenceType(bag.getType()) || (!bag.empty() && bag.getItem(0)->getName() == "Element0");
}

/** True for the count that old files write before the elements of a sequence. */
bool isSize(const xml::Element& element) {
    static constexpr const char* kWholeNumbers[] = {"long",  "ulong",  "int",   "uint",
                                                    "short", "ushort", "llong", "ullong"};
    if (element.name != "simple" || element.attributeOr("name", "") != "Size") return false;
    const std::string type = element.attributeOr("type", "");
    return std::find(std::begin(kWholeNumbers), std::end(kWholeNumbers), type) != std::end(kWholeNumbers);
}

/** True if elements and items have the same names in the same order, up to the end of the shorter list. */
bool namesAgree(const Elements& elements, const PropertyBag& bag) {
    const std::size_t common = std::min(elements.size(), bag.size());
    for (std::size_t i = 0; i != common; ++i)
        if (elements[i]->attributeOr("name", "") != bag.getItem(i)->getName()) return false;
    return true;
}

/** True if the file has the same members in another order, and the type finds its members by name. */
bool isReordered(const Elements& elements, const PropertyBag& bag) {
    const types::TypeInfo* type = types::Types()->type(bag.getType());
    if (!type || elements.size() != bag.size()) return false;
    const auto members = type->getMemberNames();
    NamePairing pairing(bag);
    return std::all_of(elements.begin(), elements.end(), [&](const xml::Element* element) {
        const std::string name = element->attributeOr("name", "");
        return std::find(members.begin(), members.end(), name) != members.end() && pairing.next(name) != bag.size();
    });
}

bool sameType(const std::string& a, const std::string& b) {
    if (a == b) return true;
    const types::TypeInfo* type = types::Types()->type(a);
    return type && type == types::Types()->type(b);
}

class Editor {
public:
    Editor(const std::string& text, bool addNew) : edit_(text), addNew_(addNew) {}

    void editItems(const xml::Element& parent, const PropertyBag& bag, std::size_t indent) {
        Elements elements;
        findProperties(parent, elements);
        const bool isValue = valueDepth_ != 0;
        if (areElements(bag)) dropSize(elements, bag);
        if (areElements(bag) || (isValue && namesAgree(elements, bag)))
            editInOrder(parent, elements, bag, indent);
        else if (!isValue || isReordered(elements, bag))
            editNamed(parent, elements, bag, indent);
        else
            refill(parent, elements, bag, indent);
    }

    std::string result() const { return edit_.result(); }

private:
    /** Removes the count: the reader would ignore an element in its place. */
    void dropSize(Elements& elements, const PropertyBag& bag) {
        if (elements.empty() || !isSize(*elements.front())) return;
        if (!bag.empty() && bag.getItem(0)->getName() == "Size") return;  // the type has such a member
        remove(*elements.front());
        elements.erase(elements.begin());
    }

    /** Afterwards there are as many elements as items. */
    void editInOrder(const xml::Element& parent, const Elements& elements, const PropertyBag& bag, std::size_t indent) {
        for (std::size_t i = 0; i != elements.size(); ++i) {
            if (i < bag.size())
                editItem(*elements[i], *bag.getItem(i), indent);
            else
                remove(*elements[i]);
        }
        appendFrom(elements.size(), parent, elements, bag, indent);
    }

    /** Writes all members anew: a type composed by users may need all of them, in their order. */
    void refill(const xml::Element& parent, const Elements& elements, const PropertyBag& bag, std::size_t indent) {
        for (const auto* element : elements) remove(*element);
        appendFrom(0, parent, elements, bag, indent);
    }

    void editNamed(const xml::Element& parent, const Elements& elements, const PropertyBag& bag, std::size_t indent) {
        NamePairing pairing(bag);
        std::vector<bool> used(bag.size());
        for (std::size_t i = 0; i != elements.size(); ++i) {
            const std::string name = elements[i]->attributeOr("name", "");
            const std::size_t at = name.empty() ? i : pairing.next(name);
            if (at >= bag.size() || (name.empty() && !bag.getItem(i)->getName().empty())) continue;
            used[at] = true;
            editItem(*elements[i], *bag.getItem(at), indent);
        }
        std::vector<PropertyBase*> missing;
        for (std::size_t i = 0; addNew_ && i != bag.size(); ++i)
            if (!used[i]) missing.push_back(bag.getItem(i));
        append(parent, elements, missing, indent);
    }

    /** `parentIndent` is the indentation of the parent element. */
    void editItem(const xml::Element& element, PropertyBase& mine, std::size_t parentIndent) {
        const std::size_t indent = edit_.indentAt(element.extent.begin, parentIndent + 3);
        const PropertyBag* bag = bagOf(mine);
        if ((bag != nullptr) != isBag(element)) return replaceItem(element, mine, indent);
        if (bag) editType(element, bag->getType());
        if (!bag) return editSimple(element, mine);
        editDescription(element, mine);
        const bool isValue = !isPlain(bag->getType());
        valueDepth_ += isValue;
        editItems(element, *bag, indent);
        valueDepth_ -= isValue;
    }

    /** Replaces the element by one of another kind. */
    void replaceItem(const xml::Element& element, PropertyBase& mine, std::size_t indent) {
        std::string text = cpfItem(mine, indent);
        if (text.empty()) return;
        text.pop_back();
        edit_.replace(element.extent.begin, element.extent.end, text.substr(indent));
    }

    void editType(const xml::Element& element, const std::string& mine) {
        const xml::Attribute* type = element.attribute("type");
        // The reader ignores the type of a <sequence> unless it is the type of a sequence.
        if (!type || (element.name == "sequence" && !isSequenceType(type->value))) return;
        if (!isPlain(mine) && !sameType(type->value, mine))
            edit_.replace(type->valueBegin, type->valueEnd, xml::escapeExactly(mine, true));
    }

    void editDescription(const xml::Element& element, const PropertyBase& mine) {
        const xml::Element* description = element.child("description");
        const bool wanted = addNew_ && valueDepth_ == 0 && !mine.getDescription().empty();
        if (!wanted || description || element.extent.isEmptyTag()) return;
        edit_.insert(element.extent.contentBegin,
                     "<description>" + xml::escapeExactly(mine.getDescription()) + "</description>");
    }

    void editSimple(const xml::Element& element, PropertyBase& mine) {
        std::string myType, myText, type, text;
        const xml::Attribute* typeName = element.attribute("type");
        const xml::Element* value = element.child("value");
        if (!typeName || !value || !writeSimple(mine, myType, myText)) return;
        // A value can be written in several ways, so both are compared in the form that the writer uses.
        const std::unique_ptr<PropertyBase> read(readSimple(typeName->value, "", "", value->text).property);
        const bool known = read && writeSimple(*read, type, text);
        if (!known || type != myType) edit_.replace(typeName->valueBegin, typeName->valueEnd, myType);
        editDescription(element, mine);
        if (known && type == myType && text == myText) return;
        if (value->extent.isEmptyTag())
            edit_.replace(value->extent.begin, value->extent.end, "<value>" + xml::escapeExactly(myText) + "</value>");
        else
            edit_.replace(value->extent.contentBegin, value->extent.contentEnd, xml::escapeExactly(myText));
    }

    void remove(const xml::Element& element) { edit_.removeWithIndent(element.extent.begin, element.extent.end); }

    void appendFrom(std::size_t first, const xml::Element& parent, const Elements& siblings, const PropertyBag& bag,
                    std::size_t indent) {
        std::vector<PropertyBase*> items;
        for (std::size_t i = first; i < bag.size(); ++i) items.push_back(bag.getItem(i));
        append(parent, siblings, items, indent);
    }

    /** Adds the items at the end of `parent`. */
    void append(const xml::Element& parent, const Elements& siblings, const std::vector<PropertyBase*>& items,
                std::size_t parentIndent) {
        const bool isRoot = parent.name == "properties";
        const std::size_t indent = siblings.empty()
                                       ? parentIndent + (isRoot ? 2 : 3)
                                       : edit_.indentAt(siblings.back()->extent.begin, parentIndent + (isRoot ? 2 : 3));
        std::string text;
        for (PropertyBase* item : items) text += cpfItem(*item, indent);
        if (text.empty()) return;
        text.pop_back();
        const auto& extent = parent.extent;
        const std::string closingLine = '\n' + std::string(parentIndent, ' ');
        if (extent.isEmptyTag()) {
            edit_.replace(extent.end - 2, extent.end, ">\n" + text + closingLine + "</" + parent.name + '>');
            return;
        }
        const std::size_t at = edit_.beforeBlanks(extent.contentEnd, extent.contentBegin);
        const bool hasLineEnd = edit_.hasLineEnd(at, extent.contentEnd);
        edit_.insert(at, '\n' + text + (hasLineEnd ? "" : closingLine));
    }

    TextEdit edit_;
    bool addNew_;
    int valueDepth_ = 0;  // depth in structs and sequences, whose members need no descriptions
};

}  // namespace

std::string editedCpf(const std::string& text, const xml::Element& root, const PropertyBag& bag, bool addNew) {
    Editor editor(text, addNew);
    editor.editItems(root, bag, 0);
    return editor.result();
}

}  // namespace RTT::marsh
