// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// oro graph
#include "session.hpp"

#include "state_text.hpp"

#include <map>

namespace oroforge::live_client {
namespace {

/** A text of the DOT language. */
std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : printable(text)) result += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    return result + "\"";
}

/** "arm" of "arm.out": a port belongs to the component that its path begins with. */
std::string componentOf(const std::string& port) { return port.substr(0, port.find('.')); }
std::string portOf(const std::string& port) {
    const std::size_t dot = port.find('.');
    return dot == std::string::npos ? "" : port.substr(dot + 1);
}

const char* colourOf(const std::string& state) {
    switch (styleOfState(state)) {
        case Style::Good: return "darkgreen";
        case Style::Bad: return "red";
        default: return "gray40";
    }
}

std::string nameOf(const Json& component) {
    return component.is_string() ? component.get<std::string>() : textOf(component, "name");
}

std::string countsOf(const Json& connection) {
    std::string text;
    if (!memberOf(connection, "samples").is_null()) text = textOf(connection, "samples") + " samples";
    if (wholeOf(connection, "dropped") > 0)
        text += (text.empty() ? "" : ", ") + textOf(connection, "dropped") + " dropped";
    return text;
}

std::string dotText(const Json& graph) {
    std::string text = "digraph deployment {\n    rankdir=LR;\n    node [shape=box, style=rounded];\n";
    for (const Json& component : memberOf(graph, "components")) {
        const std::string name = nameOf(component), state = textOf(component, "state");
        text += "    " + quoted(name) + " [color=" + colourOf(state) +
                (state.empty() ? "" : ", tooltip=" + quoted(state)) + "];\n";
    }
    for (const Json& connection : memberOf(graph, "connections")) {
        const std::string from = textOf(connection, "from"), to = textOf(connection, "to");
        text += "    " + quoted(componentOf(from)) + " -> " + quoted(componentOf(to)) +
                " [taillabel=" + quoted(portOf(from)) + ", headlabel=" + quoted(portOf(to)) +
                ", label=" + quoted(textOf(connection, "type")) + ", tooltip=" + quoted(textOf(connection, "policy")) +
                "];\n";
    }
    return text + "}\n";
}

}  // namespace

void showGraph(Session& session) {
    const Json graph = session.deployment().ask("graph");
    if (session.given().has("dot")) return session.out().write(dotText(graph));
    if (session.answeredAsJson(graph)) return;
    Table table({Style::Name, Style::Faint, Style::Name, Style::Type, Style::Plain, Style::Faint});
    std::map<std::string, bool> connected;
    for (const Json& connection : memberOf(graph, "connections")) {
        const std::string from = textOf(connection, "from"), to = textOf(connection, "to");
        connected[componentOf(from)] = connected[componentOf(to)] = true;
        table.add({printable(from), "->", printable(to), printable(textOf(connection, "type")),
                   printable(textOf(connection, "policy")), printable(countsOf(connection))});
    }
    session.out().table(table);
    Table alone({Style::Name, Style::Faint});
    for (const Json& component : memberOf(graph, "components"))
        if (!connected.count(nameOf(component))) alone.add({printable(nameOf(component)), "no connections"});
    session.out().table(alone);
}

}  // namespace oroforge::live_client
