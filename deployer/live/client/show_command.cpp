// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// oro show: the interface of a component, or a part of it, as `ls` and `help` of the console show them
#include "session.hpp"

#include "state_text.hpp"
#include "value_text.hpp"

#include <sstream>

namespace oroforge::live_client {
namespace {

constexpr std::size_t kWidestValue = 40;

std::string cell(const Json& object, const char* name) { return printable(textOf(object, name)); }

std::string valueOf(const Json& object, std::size_t width) {
    const std::string text = shownText(object);
    return text.empty() ? "" : "= " + OCL::console::shortened(text, width);
}

void title(Output& out, const std::string& text) { out.line("\n  " + out.paint(Style::Title, text)); }

void writeDoc(Output& out, const std::string& doc, const std::string& indent) {
    if (doc.empty()) return;
    const std::size_t width = out.tableWidth() > indent.size() ? out.tableWidth() - indent.size() : 0;
    for (const std::string& line : OCL::console::wrapped(printable(doc), width))
        out.line(indent + out.paint(Style::Faint, line));
}

void writeValues(Output& out, const std::string& heading, const Json& values) {
    if (values.empty()) return;
    title(out, heading);
    Table table({Style::Name, Style::Type, Style::Value, Style::Plain, Style::Faint});
    for (const Json& value : values)
        table.add({cell(value, "name"), cell(value, "type"), valueOf(value, kWidestValue), cell(value, "unit"),
                   cell(value, "doc")});
    out.table(table, "    ");
}

std::string signatureOf(const Json& operation) {
    std::string arguments;
    for (const Json& argument : memberOf(operation, "arguments")) {
        const std::string name = cell(argument, "name");
        arguments += (arguments.empty() ? "" : ", ") + cell(argument, "type") +
                     (truthOf(argument, "output") ? "&" : "") + (name.empty() ? "" : " " + name);
    }
    return cell(operation, "result") + " " + cell(operation, "name") + "(" + arguments + ")";
}

void writeOperation(Output& out, const Json& operation, const std::string& indent) {
    const std::string thread =
        textOf(operation, "thread") == "client" ? "  " + out.paint(Style::Faint, "ClientThread") : "";
    out.line(indent + out.paint(Style::Name, signatureOf(operation)) + thread);
    writeDoc(out, textOf(operation, "doc"), indent + "  ");
    Table table({Style::Plain, Style::Faint}, Table::Wrap);
    for (const Json& argument : memberOf(operation, "arguments"))
        if (!textOf(argument, "doc").empty()) table.add({cell(argument, "name"), cell(argument, "doc")});
    out.table(table, indent + "  ");
}

std::string connectionOf(const Json& port) {
    constexpr std::size_t kMostNamed = 2;  // as in the console
    const Json& others = memberOf(port, "connections");
    if (others.size() > kMostNamed) return std::to_string(others.size()) + " connections";
    std::string names;
    for (const Json& other : others)
        names += (names.empty() ? "" : ", ") +
                 (other.is_string() ? printable(other.get<std::string>()) : cell(other, "port"));
    if (!names.empty()) return (textOf(port, "direction") == "in" ? "<- " : "-> ") + names;
    const Json& connected = memberOf(port, "connected");
    return connected.is_boolean() ? connected.get<bool>() ? "connected" : "not connected" : "";
}

void writePorts(Output& out, const Json& ports) {
    if (ports.empty()) return;
    title(out, "Ports");
    Table table({Style::Faint, Style::Name, Style::Type, Style::Value, Style::Plain, Style::Faint});
    for (const Json& port : ports)
        table.add({cell(port, "direction"), cell(port, "name"), cell(port, "type"), valueOf(port, kWidestValue),
                   connectionOf(port), cell(port, "doc")});
    out.table(table, "    ");
}

/** Names with what is known of each: its state, or whether it is connected. */
void writeNames(Output& out, const std::string& heading, const Json& things) {
    if (things.empty()) return;
    title(out, heading);
    Table table({Style::Name, Style::Plain, Style::Faint});
    for (const Json& thing : things) {
        const std::string name = thing.is_string() ? printable(thing.get<std::string>()) : cell(thing, "name");
        const std::string status = cell(thing, "status"), state = cell(thing, "state");
        table.add({name, (status.empty() ? "" : status + (state.empty() ? "" : "  ")) + state + connectionOf(thing),
                   cell(thing, "doc")});
    }
    out.table(table, "    ");
}

/** Operations that every component has are named only. */
void writeOperations(Output& out, const Json& operations) {
    std::vector<std::string> usual;
    bool any = false;
    for (const Json& operation : operations) {
        if (truthOf(operation, "usual")) {
            usual.push_back(cell(operation, "name"));
            continue;
        }
        if (!any) title(out, "Operations");
        any = true;
        writeOperation(out, operation, "    ");
    }
    if (usual.empty()) return;
    title(out, "Operations of every component");
    std::ostringstream text;
    OCL::console::writeColumns(text, usual, out.theme(), Style::Name, "    ", out.width());
    out.write(text.str());
}

std::string capitalised(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

/** One property, attribute or port. */
void writeAlone(Output& out, const Json& part, const std::string& kind) {
    const std::string unit = cell(part, "unit"), value = valueOf(part, static_cast<std::size_t>(-1));
    const std::string direction = cell(part, "direction");
    out.line((direction.empty()   ? capitalised(kind)
              : direction == "in" ? "Input port"
                                  : "Output port") +
             " " + out.paint(Style::Name, cell(part, "path")) + "  " + out.paint(Style::Type, cell(part, "type")) +
             (value.empty() ? "" : "  " + out.paint(Style::Value, value)) + (unit.empty() ? "" : " " + unit));
    writeDoc(out, textOf(part, "doc"), "  ");
    if (!connectionOf(part).empty()) out.line("    " + connectionOf(part));
}

void writeInterface(Output& out, const Json& part, const std::string& kind) {
    const std::string state = cell(part, "state"), type = cell(part, "type");
    // The path of the deployer is empty.
    const std::string name = cell(part, textOf(part, "path").empty() ? "name" : "path");
    out.line(capitalised(kind) + " " + out.paint(Style::Name, name) +
             (type.empty() ? "" : "  " + out.paint(Style::Type, type)) +
             (state.empty() ? "" : "  " + out.paint(styleOfState(state), state)));
    writeDoc(out, textOf(part, "doc"), "  ");
    writeValues(out, "Properties", memberOf(part, "properties"));
    writeValues(out, "Attributes", memberOf(part, "attributes"));
    writeOperations(out, memberOf(part, "operations"));
    writePorts(out, memberOf(part, "ports"));
    writeNames(out, "Services", memberOf(part, "services"));
    writeNames(out, "Required operations", memberOf(part, "required"));
    writeNames(out, "Programs", memberOf(part, "programs"));
    writeNames(out, "State machines", memberOf(part, "machines"));
    writeNames(out, "Peers", memberOf(part, "peers"));
    const std::string missing = textOf(part, "missing");
    if (!missing.empty()) remark("warning: there are no values: " + printable(missing));
}

}  // namespace

void showPart(Session& session) {
    const Json part = session.deployment().ask("show", {{"path", session.word(0)}});
    if (session.answeredAsJson(part)) return;
    const std::string kind = textOf(part, "kind");
    if (kind == "operation")
        writeOperation(session.out(), part, "");
    else if (kind == "component" || kind == "service")
        writeInterface(session.out(), part, kind);
    else
        writeAlone(session.out(), part, kind);
}

}  // namespace oroforge::live_client
