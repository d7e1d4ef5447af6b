// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <manifest/schema.hpp>

#include <algorithm>

namespace oroforge::manifest {

namespace {

using Choices = std::vector<std::string>;

AttributeRule required(const char* name) { return {name, true, ValueKind::Text, {}}; }
AttributeRule optional(const char* name, ValueKind kind = ValueKind::Text) { return {name, false, kind, {}}; }
AttributeRule choice(const char* name, bool isRequired, Choices choices) {
    return {name, isRequired, ValueKind::Choice, std::move(choices)};
}
ChildRule once(const char* name) { return {name, false}; }
ChildRule many(const char* name) { return {name, true}; }

std::vector<ElementRule> makeRules() {
    const AttributeRule doc = optional("doc");
    return {
        {"package",
         {required("name"), optional("version"), optional("license")},
         {once("description"), many("maintainer"), many("author"), many("depend"), many("typekit"), many("component"),
          many("service"), many("plugin")}},
        {"description", {}, {}, true},
        {"doc", {}, {}, true},
        {"maintainer", {required("name"), required("email")}, {}},
        {"author", {required("name"), optional("email")}, {}},
        {"depend", {required("package")}, {}},
        {"typekit", {required("header")}, {}},
        {"component",
         {required("class"), choice("initial", false, {"PreOperational", "Stopped"}),
          choice("activity", false, {"periodic", "nonperiodic", "sequential", "slave"}),
          optional("period", ValueKind::Number), optional("priority", ValueKind::Integer),
          choice("scheduler", false, {"ORO_SCHED_RT", "ORO_SCHED_OTHER"}), optional("dynamic", ValueKind::Boolean)},
         {once("doc"), many("port"), many("property"), many("attribute"), many("operation"), many("requires"),
          many("provides"), once("hooks")}},
        {"service",
         {required("name"), required("class"), doc},
         {once("doc"), many("port"), many("property"), many("attribute"), many("operation"), many("provides")}},
        {"plugin", {required("name"), doc}, {once("doc")}},
        {"port",
         {required("name"), choice("direction", true, {"in", "out"}), required("type"),
          optional("event", ValueKind::Boolean), doc},
         {once("doc"), once("policy")}},
        {"policy",
         {choice("type", true, {"data", "buffer", "circular_buffer"}), optional("size", ValueKind::Integer),
          choice("lock", false, {"lock_free", "locked", "unsync"}), optional("init", ValueKind::Boolean),
          optional("pull", ValueKind::Boolean)},
         {}},
        {"property",
         {required("name"), required("type"), optional("default"), optional("unit"), optional("min", ValueKind::Number),
          optional("max", ValueKind::Number), doc},
         {once("doc")}},
        {"attribute",
         {required("name"), required("type"), optional("default"), optional("constant", ValueKind::Boolean),
          optional("unit"), optional("min", ValueKind::Number), optional("max", ValueKind::Number), doc},
         {once("doc")}},
        {"operation",
         {required("name"), optional("returns"), choice("thread", false, {"own", "client"}), doc},
         {once("doc"), many("arg")}},
        {"arg", {required("name"), required("type"), optional("unit"), doc}, {once("doc")}},
        {"requires", {required("service"), doc}, {once("doc"), many("operation")}},
        {"provides",
         {required("service"), doc},
         {once("doc"), many("port"), many("property"), many("attribute"), many("operation"), many("provides")}},
        {"hooks",
         {optional("configure", ValueKind::Boolean), optional("start", ValueKind::Boolean),
          optional("update", ValueKind::Boolean), optional("stop", ValueKind::Boolean),
          optional("cleanup", ValueKind::Boolean), optional("error", ValueKind::Boolean),
          optional("exception", ValueKind::Boolean)},
         {}},
    };
}

}  // namespace

const std::vector<ElementRule>& allRules() {
    static const std::vector<ElementRule> rules = makeRules();
    return rules;
}

const ElementRule* ruleFor(const std::string& element) {
    const auto& rules = allRules();
    const auto found =
        std::find_if(rules.begin(), rules.end(), [&](const ElementRule& rule) { return rule.name == element; });
    return found == rules.end() ? nullptr : &*found;
}

}  // namespace oroforge::manifest
