// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "evaluator.hpp"
#include "interface_calls.hpp"

namespace oroforge::cxx {

using Kind = Value::Kind;

void ActivityCalls::note(const clang::CallExpr& expression, const model::Activity* activity) {
    if (!findings_.isCertain()) {
        findings_.remark(expression.getExprLoc(), "OC022", "the activity is set " + findings_.why());
    } else if (activity == nullptr) {
        findings_.remark(expression.getExprLoc(), "OC025", "this activity is none that a manifest can tell");
    } else {
        registry_.activity = *activity;
    }
}

Value ActivityCalls::setPeriod(const clang::CallExpr& expression, model::Activity* activity) {
    const Value value = values_.content(expression.getArg(0));
    if (!value.is(Kind::Real) && !value.is(Kind::Number)) {
        findings_.remark(expression.getExprLoc(), "OC025", "the period of this activity is not constant");
        return {};
    }
    const double period = value.is(Kind::Real) ? value.real : static_cast<double>(value.number);
    model::Activity changed = activity != nullptr ? *activity : registry_.activity.value_or(model::Activity());
    changed.where = findings_.locate(expression.getExprLoc());
    changed.period.reset();
    if (period > 0) changed.period = numberOf(period, changed.where);
    if (changed.kind == model::ActivityKind::NonPeriodic && period > 0) changed.kind = model::ActivityKind::Periodic;
    if (changed.kind == model::ActivityKind::Periodic && !(period > 0)) changed.kind = model::ActivityKind::NonPeriodic;
    if (activity != nullptr) {
        *activity = changed;
    } else {
        note(expression, &changed);
    }
    return {};
}

std::optional<Value> ActivityCalls::call(const clang::CallExpr& expression, const std::string& name,
                                         const Place& object) {
    const Place own = Place::component().of(Place::Kind::Activity);
    if (object.isComponent() && name == "getActivity") return Value::ofPlace(own);
    if (object.isComponent() && (name == "setActivity" || name == "forceActivity")) {
        const Value value = values_.eval(expression.getArg(0));
        const model::Activity* known = registry_.activityAt(value.place);
        note(expression, known != nullptr ? known : registry_.activityAt(memory_.load(value).place));
        return Value();
    }
    model::Activity* activity = registry_.activityAt(object);
    if (name != "setPeriod" || (!object.isComponent() && object != own && activity == nullptr)) return std::nullopt;
    return setPeriod(expression, activity);
}

}  // namespace oroforge::cxx
