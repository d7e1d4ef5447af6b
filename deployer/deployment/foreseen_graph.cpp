// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "foreseen_graph.hpp"

#include "dot_text.hpp"
#include "lookup.hpp"

#include <rtt/DataFlowInterface.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/internal/flow/sample_type_name.hpp>

#include <set>
#include <sstream>

namespace OCL::deploy {
namespace {

using RTT::base::OutputPortInterface;
using RTT::base::PortInterface;

std::string componentIn(const std::string& path) { return path.substr(0, path.find('.')); }
std::string portIn(const std::string& path) {
    const std::size_t dot = path.find('.');
    return dot == std::string::npos ? path : path.substr(dot + 1);
}

bool isOutput(const PortInterface* port) { return port && port->asOutput(); }

class ForeseenGraph {
public:
    explicit ForeseenGraph(const Session& session) : session_(session) {}

    std::string text() {
        for (const Foreseen::Component& component : session_.foreseen.components) addNode(component);
        for (const Foreseen::Join& join : session_.foreseen.joins) addJoin(join);
        addComputed();
        return text_.str();
    }

private:
    void addNode(const Foreseen::Component& component) {
        const std::string& name = component.name;
        if (session_.component(name) || !nodes_.insert(name).second) return;
        line(dotQuoted(name), "label=" + (component.type.empty() ? dotQuoted(name) : dotTwoLines(name, component.type)),
             component.certain);
    }

    void addJoin(const Foreseen::Join& join) {
        switch (join.kind) {
            case Foreseen::Join::Ports: addPorts(join.one, join.two, join.certain); break;
            case Foreseen::Join::SamePorts: addSamePorts(join); break;
            case Foreseen::Join::Stream: addStream(join); break;
            case Foreseen::Join::Peer: addPeer(join); break;
        }
    }

    void addPeer(const Foreseen::Join& join) {
        const std::string style = join.certain ? "dashed" : "dotted";
        line(dotQuoted(join.one) + " -> " + dotQuoted(join.two), "style=" + style + ", label=\"peer\"", true);
    }

    void addPorts(std::string from, std::string to, bool certain) {
        std::string none;
        const PortInterface* first = findPort(session_, from, none);
        const PortInterface* second = findPort(session_, to, none);
        if (isOutput(second) || (first && !isOutput(first))) {
            std::swap(first, second);
            std::swap(from, to);
        }
        const bool isDirected = isOutput(first) || (second && !isOutput(second));
        const std::string ports = portIn(from) + (isDirected ? " → " : " – ") + portIn(to);
        const PortInterface* const typed = first ? first : second;
        const std::string label = typed ? dotTwoLines(ports, RTT::internal::sampleTypeName(*typed)) : dotQuoted(ports);
        edge(componentIn(from), componentIn(to), (isDirected ? "label=" : "dir=none, label=") + label, certain);
    }

    /** Adds what connectPorts() connects: outputs and inputs of the same name and type. */
    void addSamePorts(const Foreseen::Join& join) {
        RTT::TaskContext* const one = session_.component(join.one);
        RTT::TaskContext* const two = session_.component(join.two);
        if (!one || !two) return edge(join.one, join.two, "dir=none, label=\"ports of the same name\"", join.certain);
        for (const std::string& name : portNames(*one)) {
            const PortInterface* const first = one->ports()->getPort(name);
            const PortInterface* const second = two->ports()->getPort(name);
            if (second && isOutput(first) != isOutput(second) && first->getTypeInfo() == second->getTypeInfo())
                addPorts(join.one + "." + name, join.two + "." + name, join.certain);
        }
    }

    void addStream(const Foreseen::Join& join) {
        std::string none;
        const PortInterface* const port = findPort(session_, join.one, none);
        const std::string stream = "stream " + join.one, component = componentIn(join.one);
        if (nodes_.insert(stream).second) line(dotQuoted(stream), "shape=ellipse, label=\"stream\"", join.certain);
        const std::string label = dotQuoted(portIn(join.one));
        if (port && !isOutput(port))
            edge(stream, component, "label=" + label, join.certain);
        else
            edge(component, stream, (port ? "label=" : "dir=none, label=") + label, join.certain);
    }

    void addComputed() {
        std::string all;
        std::set<std::string> listed;
        for (const std::string& call : session_.foreseen.computed)
            if (listed.insert(call).second) all += "\\n" + dotEscaped(call);
        if (!all.empty())
            text_ << "  \"left out\" [shape=note, label=\"left out, with names that scripts compute:" << all
                  << "\"];\n";
    }

    void edge(const std::string& from, const std::string& to, const std::string& attributes, bool certain) {
        line(dotQuoted(from) + " -> " + dotQuoted(to), attributes, certain);
    }

    void line(const std::string& what, const std::string& attributes, bool certain) {
        std::string text = "  " + what + " [" + (certain ? "" : "style=dotted, ") + attributes + "];\n";
        if (lines_.insert(text).second) text_ << text;
    }

    const Session& session_;
    std::ostringstream text_;
    std::set<std::string> nodes_, lines_;
};

}  // namespace

std::string foreseenGraphOf(const Session& session) { return ForeseenGraph(session).text(); }

}  // namespace OCL::deploy
