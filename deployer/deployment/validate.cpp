// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "validate.hpp"

#include "check_described.hpp"
#include "read_value.hpp"
#include "scripts.hpp"
#include "xml_to_plan.hpp"

#include <diag/nearest_match.hpp>
#include <diag/type_match.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/scripting/script_syntax.hpp>
#include <rtt/types/GlobalsRepository.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace OCL::deploy {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool isDeployer(const std::string& name, const PlanContext& context) {
    return name == "this" || name == context.deployer;
}

/** True for the type of a struct that adds options to a component. */
bool isBag(const ComponentPlan& component) { return component.type.value == "PropertyBag"; }

class Validation {
public:
    Validation(const Plan& plan, const PlanContext& context, diag::Sink& sink)
        : plan_(plan), around_(context), sink_(sink), reachable_(context.components) {
        reachable_.push_back(context.deployer);
        reachable_.push_back("this");
        for (const Plan* earlier : context.planned)
            for (const ComponentPlan& component : earlier->components) reachable_.push_back(component.name.value);
        for (const ComponentPlan& component : plan.components) reachable_.push_back(component.name.value);
    }

    void run() {
        checkGlobals();
        checkPolicies();
        checkComponents();
    }

private:
    /** Warns of unknown global properties: plugins add them, and this process may lack a plugin that another deployer
        had. */
    void checkGlobals() {
        const RTT::PropertyBag& known = *RTT::types::GlobalsRepository::Instance()->properties();
        for (const xml::Element& properties : plan_.globals)
            for (const xml::Element& property : properties.children) {
                const Text name = nameOf(property);
                if (property.name == "description" || name.empty() || known.find(name.value)) continue;
                sink_.warning(
                    name.where, "DEP043",
                    "there is no global property '" + name.value + "'" + diag::didYouMean(name.value, known.list()));
            }
    }

    void checkPolicies() {
        std::map<std::string, const Text*> seen;
        std::set<std::string> used;
        for (const ComponentPlan& component : plan_.components)
            for (const PortPlan& port : component.ports) used.insert(port.connection.value);
        for (const PolicyPlan& policy : plan_.policies) {
            const auto first = seen.emplace(policy.name.value, &policy.name);
            if (!first.second) {
                // The same statement may be read twice, if two files include its file.
                if (policy.name.where != first.first->second->where)
                    sink_
                        .warning(policy.name.where, "DEP021",
                                 "a second policy for connection '" + policy.name.value + "', which replaces the first")
                        .note(first.first->second->where, "the first is here");
                first.first->second = &policy.name;
            } else if (!used.count(policy.name.value))
                sink_.warning(policy.name.where, "DEP018",
                              "no port takes part in connection '" + policy.name.value + "'" +
                                  diag::didYouMean(policy.name.value, {used.begin(), used.end()}));
        }
    }

    void checkComponents() {
        std::map<std::string, const ComponentPlan*> creators;
        for (const ComponentPlan& component : plan_.components) {
            if (!addsOptions(component, around_)) {
                const ComponentPlan*& creator = creators[component.name.value];
                if (creator && (isBag(component) || !isBag(*creator)))
                    checkSecond(component, *creator);
                else {
                    checkType(component);
                    creator = &component;
                }
            }
            if (component.server.value_or(false) && !around_.serves)
                sink_.warning(component.serverWhere, "DEP019", "'Server' is ignored: this deployer has no CORBA");
            checkReferences(component);
            checkServices(component);
            checkFiles(component);
        }
        checkMasters();
    }

    /** A second struct for a component adds options. It may repeat the type, but not change it. */
    void checkSecond(const ComponentPlan& component, const ComponentPlan& first) {
        const Text& name = component.name;
        const diag::Location& where = first.name.where;
        if (isBag(component)) return;
        if (component.type.value != first.type.value)
            sink_
                .error(name.where, "DEP009",
                       "a second component of the name '" + name.value + "', of type '" + component.type.value + "'")
                .note(where, "the first, of type '" + first.type.value + "', is here");
        else if (name.where != where)
            sink_
                .warning(name.where, "DEP009",
                         "a second struct for component '" + name.value + "', which adds to the options of the first")
                .note(where, "the first is here");
        else if (repeated_.insert(where.file).second)
            sink_.warning(where, "DEP009",
                          "component '" + name.value + "' is there already: '" + where.file.str() +
                              "' is included more than once");
    }

    void checkType(const ComponentPlan& component) {
        const Text& type = component.type;
        if (isBag(component))
            sink_.error(component.name.where, "DEP031",
                        "there is no component '" + component.name.value + "' to add options to" +
                            diag::didYouMean(component.name.value, reachableBut(component.name.value)));
        else if (!contains(around_.componentTypes, type.value)) {
            const std::string likely = diag::didYouMeanType(type.value, around_.componentTypes);
            const bool nothingElse = plan_.imports.empty() && !sink_.hadErrors();
            diag::Diagnostic& error =
                sink_.error(type.where, "DEP031", "unknown component type '" + type.value + "'" + likely);
            if (likely.empty() && nothingElse)
                error.hint("an 'Import' statement with the name of the package that has it makes the type known");
        }
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
        for (const Text& member : component.members) checkMember(component, member);
        if (!component.activity || component.activity->master.empty()) return;
        const Text& master = component.activity->master;
        if (!contains(reachable_, master.value))
            sink_.error(master.where, "DEP017",
                        "master '" + master.value + "' of component '" + component.name.value + "' does not exist" +
                            diag::didYouMean(master.value, reachable_));
        else if (master.value == component.name.value)
            sink_.error(master.where, "DEP017", "component '" + component.name.value + "' is its own master");
    }

    /** The chain executes a member, so this can have no other activity, nor be in another chain. */
    void checkMember(const ComponentPlan& chain, const Text& member) {
        if (member.value == "*") return;
        const std::string what = "component '" + member.value + "' is a member of chain '" + chain.name.value + "'";
        if (!contains(reachable_, member.value))
            sink_.error(member.where, "DEP016",
                        "member '" + member.value + "' of chain '" + chain.name.value + "' does not exist" +
                            diag::didYouMean(member.value, reachableBut(chain.name.value)));
        else if (member.value == chain.name.value)
            sink_.error(member.where, "DEP017", "chain '" + member.value + "' is its own member");
        const auto first = chains_.emplace(member.value, &member);
        if (!first.second && first.first->second->where != member.where)
            sink_.error(member.where, "DEP013", what + ", and of another or for a second time; leave one out")
                .note(first.first->second->where, "the first is here");
        for (const ComponentPlan& component : plan_.components)
            if (component.name.value == member.value && component.activity &&
                component.activity->master.value != chain.name.value)
                sink_.error(member.where, "DEP013", what + ", which executes it, but has an Activity; leave that out")
                    .note(component.activity->where, "the Activity is here");
    }

    void checkFiles(const ComponentPlan& component) {
        for (const PropertyFilePlan& file : component.propertyFiles) {
            if (!checkFile(file.file)) continue;
            RTT::PropertyBag scratch;
            if (const auto* read = around_.propertyFiles->read(resolveFile(file.file), sink_))
                (void)RTT::marsh::loadFrom(*read, scratch, RTT::marsh::LoadMode::load, sink_);
        }
        for (const ScriptPlan& script : component.scripts) {
            const std::string service = serviceFor(script.kind, script.file.value);
            const bool isThere = checkFile(script.file);
            if (isThere && service == "scripting") checkScript(component, script);
            const bool installed = contains(around_.services, service);
            if (isThere && installed && isLua(script.file.value)) checkLua(script);
            if (!installed)
                sink_.error(
                    script.file.where, "DEP022",
                    "cannot run script '" + script.file.value + "': the service '" + service + "' is not installed");
        }
    }

    void checkLua(const ScriptPlan& script) {
        const std::string fault = around_.luaFault ? around_.luaFault(resolveFile(script.file)) : "";
        if (!fault.empty()) sink_.error(script.file.where, "DEP068", fault);
    }

    /** Checks only the syntax of a script that will run, because running it reports other errors; of others, checks the
        rest. */
    void checkScript(const ComponentPlan& component, const ScriptPlan& script) {
        using namespace RTT::scripting::detail;
        const std::string file = resolveFile(script.file);
        if (!around_.planOnly) return checkSyntax(file, sink_);
        checkAlone(file, component.name.value,
                   script.kind == ScriptPlan::Program        ? Contents::Programs
                   : script.kind == ScriptPlan::StateMachine ? Contents::StateMachines
                                                             : Contents::Everything,
                   sink_);
    }

    bool checkFile(const Text& file) {
        const std::string why = whyUnreadable(file);
        if (!why.empty()) sink_.error(file.where, "DEP020", why);
        return why.empty();
    }

    /** Warns only if the name is similar to that of a plugin, because a component may have a service of its own. */
    void checkServices(const ComponentPlan& component) {
        if (!around_.planOnly) return;
        for (const Text& service : component.services)
            if (!contains(around_.services, service.value) && diag::nearestMatch(service.value, around_.services))
                sink_.warning(service.where, "DEP033",
                              "no plugin has a service '" + service.value + "' for component '" + component.name.value +
                                  "'" + diag::didYouMean(service.value, around_.services));
    }

    /** Reports circles: the master of a slave may be a slave, but if that leads back to the first one, none has a
        thread. */
    void checkMasters() {
        for (const Plan* earlier : around_.planned) addMasters(*earlier, false);
        addMasters(plan_, true);
        std::map<std::string, std::size_t> walks;  // the first walk that reached a component
        std::size_t walk = 0;
        for (const auto& start : masters_) {
            ++walk;
            auto at = masters_.find(start.first);
            while (at != masters_.end() && walks.emplace(at->first, walk).second)
                at = masters_.find(at->second.name->value);
            if (at != masters_.end() && walks[at->first] == walk) reportCircle(at->first);
        }
    }

    struct Master {
        const Text* name;
        bool isOfThisPlan;
    };

    /** Collects slaves and masters; the last activity of a component is used. */
    void addMasters(const Plan& plan, bool isThisPlan) {
        for (const ComponentPlan& component : plan.components) {
            for (const Text& member : component.members)
                if (member.value != "*" && member.value != component.name.value)
                    masters_[member.value] = {&component.name, isThisPlan};
            if (!component.activity) continue;
            if (component.activity->kind == ActivityKind::Slave)
                masters_[component.name.value] = {&component.activity->master, isThisPlan};
            else
                masters_.erase(component.name.value);
        }
    }

    /** Reports a circle, unless an earlier plan has all of it. Another check reports a component that is its own
        master. */
    void reportCircle(const std::string& first) {
        std::map<std::string, const Text*> members;
        bool isNew = false;
        for (auto at = masters_.find(first); members.emplace(at->first, at->second.name).second;) {
            isNew = isNew || at->second.isOfThisPlan;
            at = masters_.find(at->second.name->value);
        }
        if (!isNew || members.size() == 1) return;
        for (const auto& [name, master] : members)
            sink_.error(master->where, "DEP017", "component '" + name + "' is, through its masters, its own master");
    }

    const Plan& plan_;
    const PlanContext& around_;
    diag::Sink& sink_;
    std::vector<std::string> reachable_;
    std::map<std::string, Master> masters_;      // of slaves
    std::map<std::string, const Text*> chains_;  // of members, where the first chain names them
    std::set<diag::FileName> repeated_;          // files for which it was reported
};

}  // namespace

void validate(const Plan& plan, const PlanContext& context, diag::Sink& sink) {
    Validation(plan, context, sink).run();
    checkDescribed(plan, context, sink);
}

bool exists(const ComponentPlan& component, const PlanContext& context) {
    return isDeployer(component.name.value, context) || contains(context.components, component.name.value);
}

bool addsOptions(const ComponentPlan& component, const PlanContext& context) {
    const auto plans = [&](const ComponentPlan& earlier) { return earlier.name.value == component.name.value; };
    return exists(component, context) ||
           std::any_of(context.planned.begin(), context.planned.end(), [&](const Plan* earlier) {
               return std::any_of(earlier->components.begin(), earlier->components.end(), plans);
           });
}

}  // namespace OCL::deploy
