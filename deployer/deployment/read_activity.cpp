// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "read_value.hpp"
#include "xml_to_plan.hpp"

#include <diag/nearest_match.hpp>
#include <diag/type_match.hpp>

#include <climits>

namespace OCL::deploy {
namespace {

/** The elements that a kind of activity needs and may have. */
struct ActivityForm {
    const char* type;
    ActivityKind kind;
    bool needsPriority;
    bool needsPeriod;
};

const ActivityForm kForms[] = {
    {"Activity", ActivityKind::Activity, false, false},
    {"NonPeriodicActivity", ActivityKind::NonPeriodic, true, false},
    {"PeriodicActivity", ActivityKind::Periodic, true, true},
    {"SlaveActivity", ActivityKind::Slave, false, false},
    {"SequentialActivity", ActivityKind::Sequential, false, false},
    {"FileDescriptorActivity", ActivityKind::FileDescriptor, true, false},
};

const std::vector<std::string> kElements = {"Period", "Priority", "Scheduler", "CpuAffinity", "Master"};

const ActivityForm* formOf(const std::string& type) {
    for (const ActivityForm& form : kForms)
        if (type == form.type) return &form;
    return nullptr;
}

void readScheduler(const xml::Element& element, ActivityPlan& plan, diag::Sink& sink) {
    const auto name = readString(element, sink);
    if (!name) return;
    if (name->value == "ORO_SCHED_RT" || name->value == "ORO_SCHED_OTHER")
        plan.realTime = name->value == "ORO_SCHED_RT";
    else
        sink.error(
            name->where, "DEP015",
            "unknown scheduler '" + name->value + "', expected " + diag::oneOf({"ORO_SCHED_RT", "ORO_SCHED_OTHER"}));
}

void readElement(const xml::Element& element, TimeUnit unit, ActivityPlan& plan, diag::Sink& sink) {
    const Text name = nameOf(element);
    if (name.value == "Period") {
        plan.period = readTime(element, unit, sink);
        if (plan.period && *plan.period < 0)
            sink.error(element.where, "DEP005", "the period is negative, expected seconds, or 0 for none");
    } else if (name.value == "Priority") {
        if (const auto priority = readInteger(element, INT_MIN, INT_MAX, sink))
            plan.priority = static_cast<int>(*priority);
    } else if (name.value == "Scheduler") {
        readScheduler(element, plan, sink);
    } else if (name.value == "CpuAffinity") {
        if (const auto mask = readInteger(element, 0, UINT_MAX, sink)) plan.cpuAffinity = static_cast<unsigned>(*mask);
    } else if (name.value == "Master") {
        if (const auto master = readString(element, sink)) plan.master = *master;
    } else {
        sink.error(name.where, "DEP014",
                   "unknown element '" + name.value + "' in activity" + diag::didYouMean(name.value, kElements));
    }
}

bool mentions(const xml::Element& element, const std::string& name) {
    for (const xml::Element& child : element.children)
        if (nameOf(child).value == name) return true;
    return false;
}

void checkForm(const xml::Element& element, const ActivityForm& form, ActivityPlan& plan, diag::Sink& sink) {
    const std::string type = form.type;
    // A malformed element has been reported already.
    if (form.needsPriority && !mentions(element, "Priority"))
        sink.error(element.where, "DEP013", type + " has no 'Priority' (short)");
    if (form.needsPeriod && !mentions(element, "Period"))
        sink.error(element.where, "DEP013", type + " has no 'Period' (double, seconds)");
    if (form.needsPeriod && plan.period && *plan.period == 0)
        sink.error(element.where, "DEP013", type + " has period 0, expected more");
    if (form.kind == ActivityKind::Activity && !mentions(element, "Priority") && !mentions(element, "Period"))
        sink.error(element.where, "DEP013", "Activity has neither 'Priority' (short) nor 'Period' (double, seconds)");
    if (form.kind == ActivityKind::NonPeriodic && plan.period && *plan.period != 0)
        sink.error(element.where, "DEP013", "NonPeriodicActivity has a 'Period'; an Activity can have one");
    if (form.kind != ActivityKind::Slave && !plan.master.empty())
        sink.warning(plan.master.where, "DEP019", "'Master' has no effect in " + type + "; a SlaveActivity has one");
}

}  // namespace

ActivityPlan readActivity(const xml::Element& element, diag::Sink& sink) {
    ActivityPlan plan;
    plan.where = element.where;
    const Text type = typeOf(element);
    plan.type = type.value;
    const ActivityForm* form = formOf(type.value);
    std::vector<std::string> known;
    for (const ActivityForm& candidate : kForms) known.push_back(candidate.type);
    if (!form)
        sink.error(type.where, "DEP012",
                   "unknown activity type '" + type.value + "'" + diag::didYouMeanType(type.value, known))
            .hint("activity types are " + diag::oneOf(known));

    checkTwice(element, {}, sink);
    // A priority asks for a real-time thread; a period alone does not.
    plan.realTime = mentions(element, "Priority");
    const bool isTimeout = form && form->kind == ActivityKind::FileDescriptor;
    const TimeUnit unit = isTimeout ? TimeUnit::Milliseconds : TimeUnit::Seconds;
    for (const xml::Element& child : element.children)
        if (child.name != "description") readElement(child, unit, plan, sink);
    if (form) {
        plan.kind = form->kind;
        checkForm(element, *form, plan, sink);
    }
    return plan;
}

}  // namespace OCL::deploy
