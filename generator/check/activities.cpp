// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <check/check.hpp>

namespace oroforge::check {

namespace {

using model::ActivityKind;

void checkPeriod(const model::Component& component, diag::Sink& sink) {
    const model::Activity& activity = *component.activity;
    if (activity.kind == ActivityKind::Periodic && !activity.period) {
        sink.error(activity.where, "OM040", "a periodic activity needs the attribute 'period', in seconds");
    }
    if (!activity.period) return;
    const bool periodic = activity.kind == ActivityKind::Periodic || activity.kind == ActivityKind::Slave;
    if (!periodic) {
        sink.error(activity.period->where, "OM041", "a " + word(activity.kind) + " activity has no period");
    } else if (!(activity.period->value > 0)) {
        sink.error(activity.period->where, "OM040",
                   "period '" + activity.period->text + "' is not greater than 0 seconds");
    }
}

void checkThread(const model::Component& component, diag::Sink& sink) {
    const model::Activity& activity = *component.activity;
    const bool ownThread = activity.kind == ActivityKind::Periodic || activity.kind == ActivityKind::NonPeriodic;
    const std::string reason = "a " + word(activity.kind) + " activity has no thread of its own, thus no ";
    if (activity.priority && !ownThread) sink.error(activity.priority->where, "OM041", reason + "priority");
    if (activity.scheduler.given() && !ownThread) sink.error(activity.scheduler.where, "OM041", reason + "scheduler");
    if (activity.priority && ownThread && (activity.priority->value < 0 || activity.priority->value > 99)) {
        sink.error(activity.priority->where, "OM042",
                   "priority '" + activity.priority->text + "' is outside of 0 to 99");
    }
}

}  // namespace

void activities(const model::Package& package, diag::Sink& sink) {
    for (const auto& component : package.components) {
        if (!component.activity) continue;
        checkPeriod(component, sink);
        checkThread(component, sink);
    }
}

}  // namespace oroforge::check
