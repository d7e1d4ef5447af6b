// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The chains that a checked script would make, by chain() or as a component with slaves.
#include "chains.hpp"
#include "lookup.hpp"

#include <rtt/base/OutputPortInterface.hpp>

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>

namespace OCL::deploy {
namespace {

using RTT::base::PortInterface;

bool isOutput(const PortInterface* port) { return port && port->asOutput(); }

class ForeseenChains {
public:
    explicit ForeseenChains(const Session& session) : session_(session), foreseen_(session.foreseen) {}

    std::string text() {
        std::set<std::string> called;
        for (const Foreseen::Chain& chain : foreseen_.chains) {
            called.insert(chain.thread.component);
            add(chain);
        }
        std::set<std::string> listed;
        for (const Foreseen::Component& component : foreseen_.components)
            if ((component.type == kChainType || component.type == "FBSched") && !called.count(component.name) &&
                listed.insert(component.name).second)
                addLoaded(component);
        return text_.str();
    }

private:
    void add(const Foreseen::Chain& chain) {
        addHead(chain.thread);
        if (chain.computed) {
            text_ << "  the script computes the members\n";
            return;
        }
        std::vector<std::string> order;
        const std::vector<std::string>& said = chain.members;
        for (const std::string& name : said) {
            if (name != "*") {
                order.push_back(name);
                continue;
            }
            for (const std::string& slave : slavesOf(chain.thread.component))
                if (std::find(said.begin(), said.end(), slave) == said.end()) order.push_back(slave);
        }
        addOrder(order);
    }

    void addLoaded(const Foreseen::Component& component) {
        Foreseen::Thread thread{component.name, "a thread of its own, not periodic", component.where,
                                component.certain};
        for (const Foreseen::Thread& set : foreseen_.threads)
            if (set.component == component.name) thread.text = set.text;
        addHead(thread);
        addOrder(slavesOf(component.name));
        text_ << "  in this order unless the property sched_order says otherwise\n";
    }

    void addHead(const Foreseen::Thread& thread) {
        text_ << "chain '" << thread.component << "'" << (thread.certain ? "" : ", perhaps") << " made in "
              << thread.where << ": " << thread.text << "\n";
    }

    void addOrder(const std::vector<std::string>& order) {
        for (std::size_t i = 0; i != order.size(); ++i) text_ << "  " << i + 1 << " " << order[i] << "\n";
        for (const Foreseen::Join& join : foreseen_.joins)
            if (join.kind == Foreseen::Join::Ports) addDelay(join, order);
    }

    /** Adds the connection if a member reads by it what a later one, or itself, wrote in the cycle before. */
    void addDelay(const Foreseen::Join& join, const std::vector<std::string>& order) {
        std::string from = join.one, to = join.two, none;
        const PortInterface* writer = findPort(session_, from, none);
        const PortInterface* reader = findPort(session_, to, none);
        if (isOutput(reader) || (writer && !isOutput(writer))) {
            std::swap(from, to);
            std::swap(writer, reader);
        }
        const auto placeOf = [&](const std::string& port) {
            return std::find(order.begin(), order.end(), port.substr(0, port.find('.')));
        };
        const auto first = placeOf(from), second = placeOf(to);
        if (first == order.end() || second == order.end()) return;
        const bool isKnown = isOutput(writer) || (reader && !isOutput(reader));
        if (isKnown && first < second) return;
        if (!isKnown && first < second) std::swap(from, to);
        text_ << "  one cycle late" << (isKnown ? "" : ", if that is its direction") << ": " << from << " → " << to
              << "\n";
    }

    std::vector<std::string> slavesOf(const std::string& master) const {
        std::set<std::string> names;
        for (const Foreseen::Slave& slave : foreseen_.slaves)
            if (slave.master == master) names.insert(slave.name);
        return {names.begin(), names.end()};
    }

    const Session& session_;
    const Foreseen& foreseen_;
    std::ostringstream text_;
};

}  // namespace

std::string foreseenChainsOf(const Session& session) { return ForeseenChains(session).text(); }

}  // namespace OCL::deploy
