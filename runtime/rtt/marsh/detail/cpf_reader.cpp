// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "cpf_reader.hpp"

#include "cpf_values.hpp"

#include <rtt/internal/located_log.hpp>
#include <diag/print.hpp>

namespace RTT {
namespace marsh {

namespace {

class Reader {
public:
    Reader(diag::Sink& sink, Places* places) : sink_(sink), places_(places) {}

    void readChildren(const xml::Element& parent, PropertyBag& into) {
        for (const auto& child : parent.children) {
            if (child.name == "simple")
                readSimpleElement(child, into);
            else if (child.name == "struct" || child.name == "sequence")
                readBagElement(child, into);
            else if (child.name != "description")
                readUnknown(child, into);
        }
    }

private:
    static std::string descriptionOf(const xml::Element& element) {
        const auto* description = element.child("description");
        return description ? description->text : std::string();
    }

    void keep(const xml::Element& element, base::PropertyBase* property, PropertyBag& into) {
        into.ownProperty(property);
        if (places_) (*places_)[property] = element.where;
    }

    void warnOfTail(const xml::Element& value, const base::PropertyBase& property) {
        std::string type, taken;
        writeSimple(property, type, taken);
        sink_.warning(value.textWhere, "CPF007",
                      "text after the number in '" + value.text + "' is ignored; the value is " + taken);
    }

    void readSimpleElement(const xml::Element& element, PropertyBag& into) {
        const auto* type = element.attribute("type");
        const auto* value = element.child("value");
        const std::string name = element.attributeOr("name", "");
        if (!type) sink_.error(element.where, "CPF003", "<simple> has no attribute 'type'");
        if (!value) sink_.error(element.where, "CPF004", "property '" + name + "' has no <value>");
        if (!type || !value) return;
        const SimpleValue read = readSimple(type->value, name, descriptionOf(element), value->text);
        if (!read.knownType) {
            sink_.error(type->valueWhere, "CPF005",
                        "unknown type '" + type->value + "' of property '" + name +
                            "'; expected boolean, char, octet, short, ushort, long, ulong, "
                            "llong, ullong, float, double or string");
        } else if (!read.property) {
            sink_.error(value->textWhere, "CPF006",
                        "property '" + name + "' of type " + type->value + " cannot be '" + value->text +
                            "'; expected " + read.expected + (read.outOfRange ? " in the range of this type" : ""));
        } else {
            if (read.trailingText) warnOfTail(*value, *read.property);
            keep(element, read.property, into);
        }
    }

    void readBagElement(const xml::Element& element, PropertyBag& into) {
        auto* bag = new Property<PropertyBag>(element.attributeOr("name", ""), descriptionOf(element));
        bag->value().setType(element.name == "struct" ? element.attributeOr("type", "PropertyBag")
                                                      : sequenceType(element));
        keep(element, bag, into);
        readChildren(element, bag->value());
    }

    /** Files give all kinds of types here; only one that really is a sequence counts. */
    static std::string sequenceType(const xml::Element& element) {
        const std::string name = element.attributeOr("type", "");
        return isSequenceType(name) ? name : "Sequence";
    }

    void readUnknown(const xml::Element& element, PropertyBag& into) {
        sink_.warning(element.where, "CPF002",
                      "unknown element <" + element.name + "> is ignored; expected simple, struct or sequence");
        readChildren(element, into);
    }

    diag::Sink& sink_;
    Places* places_;
};

}  // namespace

bool readBag(const xml::Element& parent, PropertyBag& into, diag::Sink& sink, Places* places) {
    const auto before = sink.errorCount();
    Reader(sink, places).readChildren(parent, into);
    return sink.errorCount() == before;
}

std::optional<xml::Document> readText(const std::string& text, const std::string& name, PropertyBag& into,
                                      diag::Sink& sink, Places* places) {
    auto document = xml::Document::parseText(text, name, sink, xml::Blanks::condensed);
    if (!document) return std::nullopt;
    if (document->root().name != "properties") {
        sink.error(document->root().where, "CPF001", "found <" + document->root().name + ">, expected <properties>");
        return std::nullopt;
    }
    return readBag(document->root(), into, sink, places) ? std::move(document) : std::nullopt;
}

bool readFile(const std::string& file, PropertyBag& into, diag::Sink& sink, Places* places) {
    const auto text = xml::readText(file, sink);
    return text && readText(*text, file, into, sink, places);
}

void logDiagnostics(const diag::Sink& sink) {
    for (const auto& diagnostic : sink.sorted())
        RTT::internal::logLocated(diagnostic.severity == diag::Severity::Error ? Error : Warning,
                                  diag::toString(diagnostic));
}

}  // namespace marsh
}  // namespace RTT
