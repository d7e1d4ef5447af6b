// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "validate.hpp"

#include "scripts.hpp"
#include "xml_to_plan.hpp"

#include <diag/nearest_match.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/marsh/detail/property_file.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace OCL::deploy {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool isDeployer(const std::string& name, const Surroundings& surroundings) {
    return name == "this" || name == surroundings.deployer;
}

/** A struct of this type describes no component of its own: it adds to one. */
bool isBag(const ComponentPlan& component) { return component.type.value == "PropertyBag"; }

/** Proposes the type meant: the one that differs by its namespace only, or the nearest. */
std::string proposeType(const std::string& type, const std::vector<std::string>& known) {
    const std::string end = "::" + type;
    for (const std::string& candidate : known)
        if (candidate.size() > end.size() && candidate.compare(candidate.size() - end.size(), end.size(), end) == 0)
            return "; did you mean '" + candidate + "'?";
    return diag::didYouMean(type, known);
}

class Validation {
public:
    Validation(const Plan& plan, const Surroundings& surroundings, diag::Sink& sink)
        : plan_(plan), around_(surroundings), sink_(sink), reachable_(surroundings.components) {
        reachable_.push_back(surroundings.deployer);
        reachable_.push_back("this");
        for (const ComponentPlan& component : plan.components) reachable_.push_back(component.name.value);
    }

    void run() {
        checkPolicies();
        checkComponents();
    }

private:
    void checkPolicies() {
        std::map<std::string, const Text*> seen;
        std::set<std::string> used;
        for (const ComponentPlan& component : plan_.components)
            for (const PortPlan& port : component.ports) used.insert(port.connection.value);
        for (const PolicyPlan& policy : plan_.policies) {
            const auto first = seen.emplace(policy.name.value, &policy.name);
            if (!first.second)
                sink_.error(policy.name.where, "DEP021", "a second policy for connection '" + policy.name.value + "'")
                    .note(first.first->second->where, "the first is here");
            else if (!used.count(policy.name.value))
                sink_.warning(policy.name.where, "DEP018",
                              "no port takes part in connection '" + policy.name.value + "'" +
                                  diag::didYouMean(policy.name.value, {used.begin(), used.end()}));
        }
    }

    void checkComponents() {
        std::map<std::string, const Text*> seen;
        for (const ComponentPlan& component : plan_.components) {
            const bool exists = addsOptions(component, around_);
            const auto first = seen.emplace(component.name.value, &component.name);
            if (!first.second && !isBag(component) && !exists)
                sink_
                    .error(component.name.where, "DEP009",
                           "a second component of the name '" + component.name.value + "'")
                    .note(first.first->second->where, "the first is here");
            // A bag adds to what stands before it; any other struct creates.
            const bool creates = !exists && !(isBag(component) && !first.second);
            if (creates) checkType(component);
            checkReferences(component);
            checkFiles(component);
        }
    }

    void checkType(const ComponentPlan& component) {
        const Text& type = component.type;
        if (isBag(component))
            sink_.error(component.name.where, "DEP031",
                        "there is no component '" + component.name.value + "' to add options to" +
                            diag::didYouMean(component.name.value, reachableBut(component.name.value)));
        else if (!contains(around_.componentTypes, type.value))
            sink_.error(
                type.where, "DEP031",
                "unknown component type '" + type.value + "'" + proposeType(type.value, around_.componentTypes));
    }

    std::vector<std::string> reachableBut(const std::string& name) const {
        std::vector<std::string> others = reachable_;
        others.erase(std::remove(others.begin(), others.end(), name), others.end());
        return others;
    }

    void checkReferences(const ComponentPlan& component) {
        for (const Text& peer : component.peers)
            if (!contains(reachable_, peer.value))
                sink_.error(peer.where, "DEP016",
                            "peer '" + peer.value + "' of component '" + component.name.value + "' does not exist" +
                                diag::didYouMean(peer.value, reachable_));
        if (!component.activity || component.activity->master.empty()) return;
        const Text& master = component.activity->master;
        if (!contains(reachable_, master.value))
            sink_.error(master.where, "DEP017",
                        "master '" + master.value + "' of component '" + component.name.value + "' does not exist" +
                            diag::didYouMean(master.value, reachable_));
        else if (master.value == component.name.value)
            sink_.error(master.where, "DEP017", "component '" + component.name.value + "' is its own master");
    }

    void checkFiles(const ComponentPlan& component) {
        for (const PropertyFilePlan& file : component.propertyFiles) {
            RTT::PropertyBag scratch;
            if (checkFile(file.file))
                (void)RTT::marsh::loadFromFile(scratch, resolveFile(file.file), RTT::marsh::LoadMode::load, sink_);
        }
        for (const ScriptPlan& script : component.scripts) {
            (void)checkFile(script.file);
            const std::string service = serviceFor(script.kind, script.file.value);
            if (!contains(around_.services, service))
                sink_.error(
                    script.file.where, "DEP022",
                    "cannot run script '" + script.file.value + "': the service '" + service + "' is not installed");
        }
    }

    bool checkFile(const Text& file) {
        std::error_code error;
        if (std::filesystem::is_regular_file(resolveFile(file), error)) return true;
        sink_.error(file.where, "DEP020", "no such file: '" + file.value + "'");
        return false;
    }

    const Plan& plan_;
    const Surroundings& around_;
    diag::Sink& sink_;
    std::vector<std::string> reachable_;
};

}  // namespace

void validate(const Plan& plan, const Surroundings& surroundings, diag::Sink& sink) {
    Validation(plan, surroundings, sink).run();
}

bool addsOptions(const ComponentPlan& component, const Surroundings& surroundings) {
    return isDeployer(component.name.value, surroundings) || contains(surroundings.components, component.name.value);
}

}  // namespace OCL::deploy
