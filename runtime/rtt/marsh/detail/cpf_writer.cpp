// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "cpf_writer.hpp"

#include "cpf_values.hpp"

#include <rtt/Logger.hpp>
#include <rtt/types/PropertyDecomposition.hpp>
#include <rtt/types/Types.hpp>

#include <xml/escape.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>

namespace RTT {
namespace marsh {

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

private:
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

    /** Types such as enums whose simpler form is a single value. */
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
            text_.append(" name=\"").append(xml::escapeAttribute(property.getName())) += '"';
        text_.append(" type=\"").append(xml::escapeAttribute(type)).append("\">");
    }
    void writeDescription(const base::PropertyBase& property) {
        text_.append("<description>").append(xml::escapeText(property.getDescription())).append("</description>");
    }
    void writeSimpleElement(const base::PropertyBase& property, const std::string& type, const std::string& value,
                            std::size_t indent) {
        openTag("simple", property, type, indent);
        if (!property.getDescription().empty()) writeDescription(property);
        text_.append("<value>").append(xml::escapeText(value)).append("</value></simple>\n");
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

std::string cpfText(const PropertyBag& bag) {
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE properties SYSTEM \"cpf.dtd\">\n<properties>\n";
    Writer(text).writeItems(bag, 2);
    return text += "</properties>\n";
}

bool writeFile(const std::string& file, const std::string& text) {
    namespace fs = std::filesystem;
    std::error_code ignored, failed;
    const bool special = fs::exists(file, ignored) && !fs::is_regular_file(file, ignored);
    // The final path, so that a symbolic link stays one.
    fs::path target = fs::is_symlink(file, ignored) ? fs::canonical(file, ignored) : fs::path(file);
    if (target.empty()) target = file;
    const std::string written = special ? target.string() : target.string() + ".new";
    std::ofstream out(written, std::ios::binary | std::ios::trunc);
    out << text;
    out.close();
    if (out && !special) fs::rename(written, target, failed);
    if (out && !failed) return true;
    if (!special) std::remove(written.c_str());
    log(Error) << "cannot write file " << file << endlog();
    return false;
}

}  // namespace marsh
}  // namespace RTT
