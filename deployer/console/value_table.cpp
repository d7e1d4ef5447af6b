// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "value_table.hpp"

#include "table.hpp"
#include "type_name.hpp"
#include "value_text.hpp"

#include <rtt/ConfigurationInterface.hpp>

namespace OCL::console {
namespace {

typedef RTT::base::DataSourceBase::shared_ptr Source;

std::string cellOf(const Source& value, const Screen& screen) {
    return value ? "= " + shortened(valueOnOneLine(valueText(value, screen.hex)), screen.valueWidth()) : "";
}

std::string typeOf(const Source& value) { return value ? dotted(value->getTypeName()) : "?"; }

}  // namespace

void splitUnit(std::string& doc, std::string& unit) {
    unit.clear();
    if (doc.empty() || doc.back() != ']') return;
    const std::size_t open = doc.rfind('[');
    if (open == std::string::npos || (open > 0 && doc[open - 1] != ' ')) return;
    unit = doc.substr(open + 1, doc.size() - open - 2);
    doc.resize(open == 0 ? 0 : open - 1);
}

void writeProperties(Screen& screen, const RTT::PropertyBag& bag, const std::string& indent) {
    Table table({Style::Name, Style::Type, Style::Value, Style::Plain, Style::Faint});
    for (const RTT::base::PropertyBase* const property : bag) {
        std::string doc = oneLine(property->getDescription()), unit;
        splitUnit(doc, unit);
        const Source value = property->getDataSource();
        table.add({property->getName(), typeOf(value), cellOf(value, screen), unit, doc});
    }
    table.write(screen.out, screen.theme, indent, screen.tableWidth());
}

void writeAttributes(Screen& screen, const RTT::ConfigurationInterface& values, const std::string& indent) {
    Table table({Style::Name, Style::Type, Style::Value, Style::Faint});
    for (RTT::base::AttributeBase* const attribute : values.getValues()) {
        const Source value = attribute->getDataSource();
        table.add({attribute->getName(), typeOf(value), cellOf(value, screen),
                   value && !value->isAssignable() ? "constant" : ""});
    }
    table.write(screen.out, screen.theme, indent, screen.tableWidth());
}

}  // namespace OCL::console
