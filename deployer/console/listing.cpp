// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "listing.hpp"

#include "interface_text.hpp"
#include "port_table.hpp"
#include "scripted.hpp"
#include "table.hpp"
#include "value_table.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/ServiceRequester.hpp>
#include <rtt/types/Types.hpp>

#include <algorithm>
#include <ostream>

namespace OCL::console {
namespace {

using RTT::TaskContext;

constexpr const char* kIndent = "    ";
constexpr const char* kUsualDoc = "The interface of this TaskContext.";

void title(Screen& screen, const char* text) { screen.out << "\n  " << screen.paint(Style::Title, text) << '\n'; }

std::string stateOf(TaskContext& component) { return std::string("[") + stateLetter(component) + "]"; }

void listNames(Screen& screen, const char* text, const std::vector<std::string>& names) {
    if (names.empty()) return;
    title(screen, text);
    writeColumns(screen.out, names, screen.theme, Style::Name, kIndent, screen.width());
}

void listOperations(Screen& screen, const NamedObject& target) {
    auto names = target.service->getNames();
    const auto usual = target.component ? standardOperationsLast(names) : names.end();
    listNames(screen, "Operations", {names.begin(), usual});
    listNames(screen, kUsualOperations, {usual, names.end()});
}

void listServices(Screen& screen, const NamedObject& target) {
    RTT::Service& service = *target.service;
    const auto scripted = target.component ? scriptedNames(*target.component) : std::vector<std::string>();
    Table table({Style::Name, Style::Faint});
    for (const std::string& name : service.getProviderNames()) {
        const auto provided = service.getService(name);
        // Ports, programs and state machines have sections of their own.
        const bool hasSection =
            service.getPort(name) || std::find(scripted.begin(), scripted.end(), name) != scripted.end();
        if (provided && !hasSection) table.add({name, oneLine(provided->doc())});
    }
    if (table.empty()) return;
    title(screen, "Services");
    table.write(screen.out, screen.theme, kIndent, screen.tableWidth());
}

void addCallers(Table& table, const RTT::ServiceRequester& requester, const std::string& prefix) {
    for (const std::string& name : requester.getOperationCallerNames()) {
        const auto* const caller = requester.getOperationCaller(name);
        table.add({prefix + name, caller && caller->ready() ? "connected" : "not connected"});
    }
}

void listRequired(Screen& screen, TaskContext& component) {
    Table table({Style::Name, Style::Faint});
    const auto required = component.requires_();
    addCallers(table, *required, "");
    for (const std::string& name : required->getRequesterNames())
        addCallers(table, *required->requires_(name), name + ".");
    if (table.empty()) return;
    title(screen, "Required operations");
    table.write(screen.out, screen.theme, kIndent, screen.tableWidth());
}

void listScripted(Screen& screen, TaskContext& component, bool machines) {
    Table table({Style::Name, Style::Plain, Style::Faint});
    for (const Scripted& each : scriptedIn(component, machines))
        table.add({each.name, each.status, each.state.empty() ? "" : "in state " + each.state});
    if (table.empty()) return;
    title(screen, machines ? "State machines" : "Programs");
    table.write(screen.out, screen.theme, kIndent, screen.tableWidth());
}

void listPeers(Screen& screen, TaskContext& component) {
    std::vector<std::string> peers;
    for (const std::string& name : component.getPeerList()) {
        TaskContext* const peer = component.getPeer(name);
        peers.push_back(name + " " + (peer && peer->ready() ? stateOf(*peer) : "[X]"));
    }
    listNames(screen, "Peers", peers);
}

void writeHead(Screen& screen, const NamedObject& target) {
    const std::string kind = target.component ? "Component " : "Service ",
                      state = target.component ? " " + stateOf(*target.component) : "",
                      doc = target.service->doc() == kUsualDoc ? "" : oneLine(target.service->doc());
    const std::size_t at = widthOf(kind + target.name + state) + 2, width = screen.tableWidth();
    screen.out << kind << screen.paint(Style::Name, target.name) << state;
    if (!doc.empty() && (width == 0 || at < width))
        screen.out << "  " << screen.paint(Style::Faint, width == 0 ? doc : shortened(doc, width - at));
    screen.out << '\n';
}

bool hasUnknownType(RTT::Service& service) {
    const RTT::types::TypeInfo* const unknown = RTT::types::Types()->unknownType();
    const auto isUnknown = [&](const auto* value) {
        return value->getDataSource() && value->getDataSource()->getTypeInfo() == unknown;
    };
    const auto values = service.getValues();
    const auto ports = service.getPorts();
    return std::any_of(values.begin(), values.end(), isUnknown) ||
           std::any_of(service.properties()->begin(), service.properties()->end(), isUnknown) ||
           std::any_of(ports.begin(), ports.end(), [&](const auto* port) { return port->getTypeInfo() == unknown; });
}

}  // namespace

void list(Screen& screen, const NamedObject& target, const std::vector<Gate>& around) {
    RTT::Service& service = *target.service;
    writeHead(screen, target);
    if (!service.properties()->empty()) {
        title(screen, "Properties");
        writeProperties(screen, *service.properties(), kIndent);
    }
    if (!service.getValues().empty()) {
        title(screen, "Attributes");
        writeAttributes(screen, service, kIndent);
    }
    listOperations(screen, target);
    if (!service.getPorts().empty()) {
        title(screen, "Ports");
        writePorts(screen, service, kIndent, around);
    }
    if (hasUnknownType(service))
        screen.out << "\n  " << screen.paint(Style::Faint, "unknown_t: no typekit that is loaded has this type")
                   << '\n';
    listServices(screen, target);
    if (!target.component) return;
    listRequired(screen, *target.component);
    listScripted(screen, *target.component, false);
    listScripted(screen, *target.component, true);
    listPeers(screen, *target.component);
}

}  // namespace OCL::console
