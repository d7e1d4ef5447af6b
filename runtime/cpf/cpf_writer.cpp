// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "cpf_writer.hpp"

#include "cpf_values.hpp"
#include "replace_file.hpp"

#include <rtt/Logger.hpp>
#include <rtt/types/PropertyDecomposition.hpp>
#include <rtt/types/Types.hpp>

#include <xml/escape.hpp>

#include <memory>

namespace RTT::marsh {

namespace xml = oroforge::xml;

namespace {

const PropertyBag* bagIn(const base::PropertyBase& property) {
    const auto* bag = dynamic_cast<const Property<PropertyBag>*>(&property);
    return bag ? &bag->rvalue() : nullptr;
}

class Writer {
public:
    explicit Writer(std::string& text) : text_(text) {}

    void writeItems(const PropertyBag& bag, std::size_t indent) {
        for (auto* property : bag) write(*property, indent);
    }

    void write(base::PropertyBase& property, std::size_t indent) {
        std::string type, value;
        if (writeSimple(property, type, value)) return writeSimpleElement(property, type, value, indent);
        if (const PropertyBag* bag = bagIn(property)) return writeStruct(property, *bag, indent);
        PropertyBag members;
        if (types::propertyDecomposition(&property, members, true)) return writeStruct(property, members, indent);
        if (writeAsSimpler(property, indent)) return;
        log(Error) << "property '" << property.getName() << "' is not written: type " << property.getType()
                   << " has no form in property files" << endlog();
    }

private:
    /** Writes a value, such as an enum, that can be taken apart into a single simple value. */
    bool writeAsSimpler(const base::PropertyBase& property, std::size_t indent) {
        const auto source = property.getDataSource();
        const auto simpler = source->getTypeInfo()->decomposeType(source);
        if (!simpler) return false;
        const std::unique_ptr<base::PropertyBase> shown(
            simpler->getTypeInfo()->buildProperty(property.getName(), property.getDescription(), simpler));
        std::string type, value;
        if (!shown || !writeSimple(*shown, type, value)) return false;
        writeSimpleElement(*shown, type, value, indent);
        return true;
    }

    void openTag(const char* tag, const base::PropertyBase& property, const std::string& type, std::size_t indent) {
        text_.append(indent, ' ').append("<").append(tag);
        if (!property.getName().empty())
            text_.append(" name=\"").append(xml::escapeExactly(property.getName(), true)) += '"';
        text_.append(" type=\"").append(xml::escapeExactly(type, true)).append("\">");
    }
    void writeDescription(const base::PropertyBase& property) {
        text_.append("<description>").append(xml::escapeExactly(property.getDescription())).append("</description>");
    }
    void writeSimpleElement(const base::PropertyBase& property, const std::string& type, const std::string& value,
                            std::size_t indent) {
        openTag("simple", property, type, indent);
        if (!property.getDescription().empty()) writeDescription(property);
        text_.append("<value>").append(xml::escapeExactly(value)).append("</value></simple>\n");
    }
    void writeStruct(const base::PropertyBase& property, const PropertyBag& bag, std::size_t indent) {
        openTag("struct", property, bag.getType(), indent);
        text_ += '\n';
        if (!property.getDescription().empty()) {
            text_.append(indent + 3, ' ');
            writeDescription(property);
            text_ += '\n';
        }
        writeItems(bag, indent + 3);
        text_.append(indent, ' ').append("</struct>\n");
    }

    std::string& text_;
};

}  // namespace

std::string cpfFrame(const std::string& items) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE properties SYSTEM \"cpf.dtd\">\n<properties>\n" +
           items + "</properties>\n";
}

std::string cpfText(const PropertyBag& bag) {
    std::string items;
    Writer(items).writeItems(bag, 2);
    return cpfFrame(items);
}

std::string cpfItem(base::PropertyBase& property, std::size_t indent) {
    std::string text;
    Writer(text).write(property, indent);
    return text;
}

bool writeFile(const std::string& file, const std::string& text) {
    const std::error_code failed = replaceFile(file, text);
    if (failed) log(Error) << "cannot write file " << file << ": " << failed.message() << endlog();
    return !failed;
}

}  // namespace RTT::marsh
