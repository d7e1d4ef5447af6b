// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "interface_text.hpp"

#include "known_ports.hpp"
#include "port_table.hpp"
#include "table.hpp"
#include "type_name.hpp"
#include "value_table.hpp"
#include "value_text.hpp"

#include <rtt/OperationInterface.hpp>
#include <rtt/ServiceRequester.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/internal/ConnectionManager.hpp>
#include <rtt/internal/calls/standard_operations.hpp>
#include <rtt/types/CompositionFactory.hpp>
#include <rtt/types/GlobalsRepository.hpp>
#include <rtt/types/MemberFactory.hpp>
#include <rtt/types/Types.hpp>

#include <algorithm>
#include <ostream>
#include <set>

namespace OCL::console {
namespace {

constexpr const char* kFurther = "    ";  // indent of further lines of a signature

/** The type without const and reference, unless the argument is also a result. */
std::string argumentType(const std::string& type) {
    static const std::string kConst = " const&";
    const bool in =
        type.size() > kConst.size() && type.compare(type.size() - kConst.size(), kConst.size(), kConst) == 0;
    return dotted(in ? type.substr(0, type.size() - kConst.size()) : type);
}

void title(Screen& screen, const char* text) { screen.out << "\n  " << screen.paint(Style::Title, text) << '\n'; }

/** The width for text after the indent; 0 if there is no limit. */
std::size_t roomIn(const Screen& screen, const std::string& indent) {
    const std::size_t width = screen.tableWidth();
    return width > indent.size() ? width - indent.size() : 0;
}

void writeDoc(Screen& screen, const std::string& doc, const std::string& indent) {
    if (doc.empty()) return;
    for (const std::string& line : wrapped(oneLine(doc), roomIn(screen, indent)))
        screen.out << indent << screen.paint(Style::Faint, line) << '\n';
}

/** Writes the members of a struct with their types, units and documentation. */
void writeMembers(Screen& screen, const RTT::base::DataSourceBase::shared_ptr& value, const std::string& indent) {
    const RTT::types::TypeInfo& type = *value->getTypeInfo();
    const auto factory = type.getMemberFactory();
    Table table({Style::Name, Style::Type, Style::Value, Style::Faint});
    for (const std::string& name : value->getMemberNames()) {
        const auto member = value->getMember(name);
        if (!member) continue;
        table.add({"." + name, dotted(member->getTypeName()),
                   "= " + shortened(valueOnOneLine(valueText(member, screen.hex)), screen.valueWidth()),
                   factory ? factory->describeMember(name) : ""});
    }
    table.write(screen.out, screen.theme, indent, screen.tableWidth());
}

/** Writes "  title: a, b" in lines that fit; nothing if there are no names. */
void writeNames(Screen& screen, const std::string& title, const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? title + ": " : ", ") + name;
    writeDoc(screen, text, "  ");
}

std::vector<std::string> otherNames(const RTT::types::TypeInfo& type) {
    std::set<std::string> names;
    for (const std::string& name : type.getTypeNames()) names.insert(dotted(name));
    names.erase(dotted(type.getTypeName()));
    return {names.begin(), names.end()};
}

/** The types from which a single value converts to `type`. */
std::vector<std::string> madeFrom(const RTT::types::TypeInfo& type) {
    std::set<std::string> names;
    for (const std::string& each : RTT::types::Types()->getTypes()) {
        const RTT::types::TypeInfo* const other = RTT::types::Types()->type(each);
        if (!other || other == &type) continue;
        const auto value = other->buildValue();
        if (value && type.construct({value})) names.insert(dotted(other->getTypeName()));
    }
    return {names.begin(), names.end()};
}

void writeEnumerators(Screen& screen, const RTT::types::TypeInfo& type, const std::vector<std::string>& names) {
    const auto value = type.buildValue();
    Table table({Style::Name, Style::Value});
    for (const std::string& name : names) {
        const bool known = value && type.fromString(name, value);
        const auto number = known ? RTT::types::Types()->getTypeInfo<int>()->convert(value) : nullptr;
        table.add({name, number && number != value ? "= " + valueText(number, screen.hex) : ""});
    }
    table.write(screen.out, screen.theme, "    ", screen.tableWidth());
}

}  // namespace

std::vector<std::string>::iterator standardOperationsLast(std::vector<std::string>& names) {
    return std::stable_partition(names.begin(), names.end(),
                                 [](const std::string& name) { return !RTT::internal::standardOperation(name); });
}

std::string signatureOf(const RTT::OperationInterface& operations, const std::string& name) {
    std::string text = dotted(operations.getResultType(name)) + " " + name + "(";
    bool first = true;
    for (const RTT::ArgumentDescription& argument : operations.getArgumentList(name)) {
        text += (first ? "" : ", ") + argumentType(argument.type) + (argument.name.empty() ? "" : " " + argument.name);
        first = false;
    }
    return text + ")";
}

void describeOperation(Screen& screen, const RTT::OperationInterface& operations, const std::string& name,
                       const std::string& indent) {
    const char* further = "";
    for (const std::string& line : wrapped(signatureOf(operations, name), roomIn(screen, indent + kFurther))) {
        screen.out << indent << further << screen.paint(Style::Name, line) << '\n';
        further = kFurther;
    }
    writeDoc(screen, operations.getDescription(name), indent + "  ");
    Table table({Style::Plain, Style::Faint}, Table::Wrap);
    for (const RTT::ArgumentDescription& argument : operations.getArgumentList(name))
        if (!argument.description.empty()) table.add({argument.name, oneLine(argument.description)});
    table.write(screen.out, screen.theme, indent + "  ", screen.tableWidth());
}

void describeInterface(Screen& screen, const NamedObject& target, const std::vector<Gate>& around) {
    RTT::Service& service = *target.service;
    screen.out << (target.component ? "Component " : "Service ") << screen.paint(Style::Name, target.name) << '\n';
    writeDoc(screen, service.doc(), "  ");
    if (!service.properties()->empty()) {
        title(screen, "Properties");
        writeProperties(screen, *service.properties(), "    ");
    }
    if (!service.getValues().empty()) {
        title(screen, "Attributes");
        writeAttributes(screen, service, "    ");
    }
    auto operations = service.getNames();
    const auto usual = target.component ? standardOperationsLast(operations) : operations.end();
    for (auto each = operations.begin(); each != operations.end(); ++each) {
        if (each == usual)
            title(screen, kUsualOperations);
        else if (each == operations.begin())
            title(screen, "Operations");
        describeOperation(screen, service, *each, "    ");
    }
    if (!service.getPorts().empty()) {
        title(screen, "Ports");
        writePorts(screen, service, "    ", around);
    }
    std::vector<std::string> services;
    for (const std::string& name : service.getProviderNames())
        if (!service.getPort(name)) services.push_back(name);
    if (services.empty()) return;
    title(screen, "Services");
    writeColumns(screen.out, services, screen.theme, Style::Name, "    ", screen.width());
}

void describeGlobals(Screen& screen) {
    const auto globals = RTT::types::GlobalsRepository::Instance();
    screen.out << "Globals\n";
    if (!globals->properties()->empty()) {
        title(screen, "Properties");
        writeProperties(screen, *globals->properties(), "    ");
    }
    if (globals->getValues().empty()) return;
    title(screen, "Attributes");
    writeAttributes(screen, *globals, "    ");
}

void describeRequester(Screen& screen, const RTT::ServiceRequester& requester) {
    screen.out << "Required service " << screen.paint(Style::Name, requester.getRequestName()) << '\n';
    for (const std::string& name : requester.getOperationCallerNames()) {
        const auto* const caller = requester.getOperationCaller(name);
        screen.out << "    " << name << (caller && caller->ready() ? "  connected\n" : "  not connected\n");
    }
}

bool describeValue(Screen& screen, const RTT::ConfigurationInterface& values, const std::string& name) {
    const RTT::base::PropertyBase* const property = values.getProperty(name);
    RTT::base::AttributeBase* const attribute = values.getValue(name);
    if (!property && !attribute) return false;
    const auto value = property ? property->getDataSource() : attribute->getDataSource();
    std::string doc = property ? oneLine(property->getDescription()) : "", unit;
    splitUnit(doc, unit);
    screen.out << (property ? "Property " : "Attribute ") << screen.paint(Style::Name, name) << "  "
               << screen.paint(Style::Type, dotted(value->getTypeName())) << "  = "
               << screen.paint(Style::Value, valueText(value, screen.hex)) << (unit.empty() ? "" : " " + unit) << '\n';
    writeDoc(screen, doc, "  ");
    writeMembers(screen, value, "    ");
    return true;
}

bool describeType(Screen& screen, const std::string& name) {
    const RTT::types::TypeInfo* const type = RTT::types::Types()->type(name);
    if (!type) return false;
    const auto factory = type->getCompositionFactory();
    const auto* const enumeration = dynamic_cast<const RTT::types::Enumeration*>(factory.get());
    screen.out << (enumeration ? "Enum " : "Type ") << screen.paint(Style::Type, dotted(type->getTypeName())) << '\n';
    writeDoc(screen, type->getDescription(), "  ");
    writeNames(screen, "also called", otherNames(*type));
    const auto value = type->buildValue();
    const auto members = value ? value->getMemberNames() : std::vector<std::string>();
    if (std::find(members.begin(), members.end(), "capacity") == members.end()) {
        writeNames(screen, "made from", madeFrom(*type));
    } else if (const auto element = value->getMember("0")) {
        writeNames(screen, "elements", {dotted(element->getTypeName())});
    }
    if (enumeration) writeEnumerators(screen, *type, enumeration->enumerators());
    // Only a value shows the members and their initial contents.
    else if (value)
        writeMembers(screen, value, "    ");
    return true;
}

bool describePort(Screen& screen, RTT::Service& service, const std::string& name, const std::string& path,
                  const std::vector<Gate>& around) {
    const RTT::base::PortInterface* const port = service.getPort(name);
    if (!port) return false;
    const bool input = port->asInput();
    screen.out << (input ? "Input port " : "Output port ") << screen.paint(Style::Name, name) << "  "
               << screen.paint(Style::Type, dotted(port->getTypeInfo()->getTypeName())) << '\n';
    writeDoc(screen, port->getDescription(), "  ");
    for (const auto& connection : port->getManager()->getConnections()) {
        const auto& id = connection.get<0>();
        screen.out << "    " << (input ? "<- " : "-> ") << (id->peer() ? id->peer()->getFullName() : id->toString())
                   << "  " << connection.get<2>() << '\n';
    }
    if (const auto last = lastSampleOf(*port, around))
        screen.out << (input ? "    last sample: " : "    last written: ") << valueText(last, screen.hex) << '\n';
    screen.out << "    " << screen.paint(Style::Faint, path + (input ? ".read(x)" : ".write(x)")) << '\n';
    return true;
}

}  // namespace OCL::console
