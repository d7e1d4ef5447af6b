// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "cpf_reader.hpp"

#include "cpf_values.hpp"

#include <rtt/internal/diagnostic_taker.hpp>
#include <rtt/internal/located_log.hpp>
#include <diag/print.hpp>

#include <atomic>

namespace RTT::marsh {

namespace {

std::atomic<bool> lenientProcess{false};

/** True for a number whose fraction is 0, such as 3.0: it has the same value without it. */
bool isWholeNumber(const std::string& text) {
    const std::size_t point = text.find_first_not_of("+-0123456789");
    return point != std::string::npos && point != 0 && text[point] == '.' &&
           text.find_first_not_of('0', point + 1) == std::string::npos;
}

class Reader {
public:
    Reader(diag::Sink& sink, Places* places) : sink_(sink), places_(places) {}

    void readChildren(const xml::Element& parent, PropertyBag& into) {
        for (const auto& child : parent.children) readChild(child, into);
    }

    void readChild(const xml::Element& child, PropertyBag& into) {
        if (child.name == "simple")
            readSimpleElement(child, into);
        else if (child.name == "struct" || child.name == "sequence")
            readBagElement(child, into);
        else if (child.name != "description")
            readUnknown(child, into);
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

    bool takesTail(const xml::Element& value, const std::string& type, const SimpleValue& read) {
        std::string written, taken;
        writeSimple(*read.property, written, taken);
        return reportTextBehindNumber(value.textWhere,
                                      "property '" + read.property->getName() + "' of type " + type + " cannot be",
                                      value.text, taken, read.expected, sink_);
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
            if (!read.trailingText || takesTail(*value, type->value, read))
                keep(element, read.property, into);
            else
                delete read.property;
        }
    }

    void readBagElement(const xml::Element& element, PropertyBag& into) {
        auto* bag = new Property<PropertyBag>(element.attributeOr("name", ""), descriptionOf(element));
        bag->value().setType(element.name == "struct" ? element.attributeOr("type", "PropertyBag")
                                                      : sequenceType(element));
        keep(element, bag, into);
        readChildren(element, bag->value());
    }

    /** The type that the file gives, if it is the type of a sequence: files write all kinds of types here. */
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

/** Of the elements that are known, only values and descriptions may have text. */
void checkTexts(const xml::Element& element, diag::Sink& sink) {
    if (element.name == "value" || element.name == "description") return;
    const bool isBag = element.name == "properties" || element.name == "struct" || element.name == "sequence";
    if (!element.text.empty() && (isBag || element.name == "simple")) reportStrayText(element, "CPF008", sink);
    if (isBag)
        for (const xml::Element& child : element.children) checkTexts(child, sink);
}

bool checkRoot(const xml::Element& root, diag::Sink& sink) {
    if (root.name == "properties") return true;
    sink.error(root.where, "CPF001", "found <" + root.name + ">, expected <properties>");
    return false;
}

}  // namespace

void setLenientReading(bool lenient) { lenientProcess = lenient; }

bool lenientReading() { return lenientProcess; }

bool reportTextBehindNumber(const diag::Location& where, const std::string& what, const std::string& text,
                            const std::string& taken, const std::string& expected, diag::Sink& sink) {
    if (lenientProcess || isWholeNumber(text)) {
        sink.warning(where, "CPF007", "text after the number in '" + text + "' is ignored; the value is " + taken);
        return true;
    }
    sink.error(where, "CPF007", what + " '" + text + "', with text after the number; expected " + expected);
    return false;
}

void reportStrayText(const xml::Element& element, const char* code, diag::Sink& sink) {
    const std::string text = element.text.substr(0, 40) + (element.text.size() > 40 ? "..." : "");
    const std::string found = "found the text '" + text + "' in <" + element.name + ">";
    const std::string instead = element.name == "simple" ? "put a value into <value>" : "expected elements only";
    if (lenientProcess)
        sink.warning(element.textWhere, code, found + ", which is ignored; " + instead);
    else
        sink.error(element.textWhere, code, found + "; " + instead);
}

bool readBag(const xml::Element& parent, PropertyBag& into, diag::Sink& sink, Places* places) {
    const auto before = sink.errorCount();
    Reader(sink, places).readChildren(parent, into);
    return sink.errorCount() == before;
}

void checkProperty(const xml::Element& child, diag::Sink& sink) {
    PropertyBag scratch;
    Reader(sink, nullptr).readChild(child, scratch);
}

std::optional<xml::Document> readText(const std::string& text, const std::string& name, PropertyBag& into,
                                      diag::Sink& sink, Places* places) {
    auto document = xml::Document::parseText(text, name, sink, xml::Blanks::condensed);
    if (!document) return std::nullopt;
    if (!checkRoot(document->root(), sink)) return std::nullopt;
    const auto before = sink.errorCount();
    checkTexts(document->root(), sink);
    return readBag(document->root(), into, sink, places) && sink.errorCount() == before ? std::move(document)
                                                                                        : std::nullopt;
}

bool readFile(const std::string& file, PropertyBag& into, diag::Sink& sink, Places* places) {
    const auto text = xml::readText(file, sink);
    if (!text) return false;
    const auto before = sink.errorCount();
    Reader reader(sink, places);
    const auto take = [&](const xml::Element& root, const xml::Element& child) {
        if (root.name != "properties") return;
        checkTexts(child, sink);
        reader.readChild(child, into);
    };
    const auto document = xml::Document::parseText(*text, file, sink, xml::Blanks::condensed, take);
    if (document && checkRoot(document->root(), sink)) checkTexts(document->root(), sink);
    return sink.errorCount() == before;
}

void logDiagnostics(const diag::Sink& sink) {
    if (RTT::internal::takeDiagnostics(sink)) return;
    for (const auto& diagnostic : sink.sorted())
        RTT::internal::logLocated(diagnostic.severity == diag::Severity::Error ? Error : Warning,
                                  diag::toString(diagnostic));
}

}  // namespace RTT::marsh
