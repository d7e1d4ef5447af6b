// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The chains of files that are only checked: their components do not exist.
#include "chains.hpp"
#include "read_value.hpp"

#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/internal/ComponentDescription.hpp>
#include <rtt/os/fosi.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace OCL::deploy {
namespace {

using RTT::internal::ComponentDescription;
using RTT::internal::ComponentDescriptions;

class PlannedChains {
public:
    explicit PlannedChains(const Session& session) {
        for (const Plan& plan : session.planned)
            for (const ComponentPlan& component : plan.components) {
                ComponentPlan& known = components_[component.name.value];
                ComponentRecords::merge(known, component);
            }
    }

    std::string text() {
        std::ostringstream text;
        for (const auto& [name, component] : components_)
            if (isChain(component)) add(text, name, component);
        return text.str();
    }

private:
    static bool isChain(const ComponentPlan& component) {
        return component.type.value == kChainType || component.type.value == "FBSched" || !component.members.empty();
    }

    void add(std::ostream& out, const std::string& name, const ComponentPlan& chain) const {
        const std::vector<std::string> order = orderOf(name, chain);
        out << "chain '" << name << "': " << threadOf(name, chain) << "\n";
        for (std::size_t i = 0; i != order.size(); ++i) out << "  " << i + 1 << " " << order[i] << "\n";
        for (std::size_t to = 0; to != order.size(); ++to)
            for (std::size_t from = to; from != order.size(); ++from) addDelays(out, order[from], order[to]);
    }

    std::string threadOf(const std::string& name, const ComponentPlan& chain) const {
        for (const auto& [other, component] : components_)
            for (const Text& member : component.members)
                if (member.value == name) return "in the thread of '" + other + "'";
        if (!chain.activity) return "a thread of its own, not periodic";
        const ActivityPlan& plan = *chain.activity;
        if (!plan.master.empty()) return "in the thread of '" + plan.master.value + "'";
        const ActivityNumbers numbers = numbersOf(plan);
        std::ostringstream text;
        text << plan.type << ", " << (plan.realTime ? "ORO_SCHED_RT" : "ORO_SCHED_OTHER") << ", priority "
             << numbers.priority;
        if (numbers.period > 0)
            text << ", period " << numbers.period << " s";
        else
            text << ", not periodic";
        return text.str();
    }

    /** Members, or the property sched_order; the other slaves replace "*", or are all if nothing is said. */
    std::vector<std::string> orderOf(const std::string& name, const ComponentPlan& chain) const {
        std::vector<std::string> said, slaves, result;
        for (const Text& member : chain.members) said.push_back(member.value);
        for (const xml::Element& properties : chain.properties)
            for (const xml::Element& property : properties.children)
                if (nameOf(property).value == "sched_order") said = textsOf(property);
        for (const auto& [other, component] : components_) {
            const bool isSlave = component.activity && component.activity->master.value == name;
            if (isSlave && std::find(said.begin(), said.end(), other) == said.end()) slaves.push_back(other);
        }
        const bool hasOthers = std::find(said.begin(), said.end(), "*") != said.end();
        if (said.empty() || (chain.type.value == "FBSched" && !hasOthers)) said.push_back("*");
        for (const std::string& one : said)
            if (one == "*")
                result.insert(result.end(), slaves.begin(), slaves.end());
            else
                result.push_back(one);
        return result;
    }

    static std::vector<std::string> textsOf(const xml::Element& sequence) {
        diag::Sink faults;  // a check has reported them
        std::vector<std::string> texts;
        for (const xml::Element& element : sequence.children)
            if (const auto text = element.name == "simple" ? readString(element, faults) : std::nullopt)
                texts.push_back(text->value);
        return texts;
    }

    /** Adds the connections by which a member that comes earlier reads what a later one writes. */
    void addDelays(std::ostream& out, const std::string& from, const std::string& to) const {
        const auto writer = components_.find(from), reader = components_.find(to);
        if (writer == components_.end() || reader == components_.end()) return;
        for (const PortPlan& output : writer->second.ports)
            for (const PortPlan& input : reader->second.ports)
                if (output.connection.value == input.connection.value && (from != to || &output != &input)) {
                    const int outward = direction(writer->second, output), inward = direction(reader->second, input);
                    if (outward < 0 || inward > 0) continue;
                    out << "  one cycle late" << (outward == 0 || inward == 0 ? ", if that is its direction" : "")
                        << ": " << from << "." << output.port.value << " → " << to << "." << input.port.value << "\n";
                }
    }

    /** 1 for an output, -1 for an input, 0 if no library describes the port. */
    static int direction(const ComponentPlan& component, const PortPlan& port) {
        const auto create = RTT::ComponentLoader::Instance()->factoryOf(component.type.value);
        if (!create) return 0;
        const ComponentDescription* const described =
            ComponentDescriptions::find(component.type.value, reinterpret_cast<const void*>(create));
        if (!described) return 0;
        for (const auto& one : described->ports)
            if (one.name == port.port.value) return one.output ? 1 : -1;
        return 0;
    }

    std::map<std::string, ComponentPlan> components_;
};

}  // namespace

std::string plannedChainsOf(const Session& session) { return PlannedChains(session).text(); }

}  // namespace OCL::deploy
