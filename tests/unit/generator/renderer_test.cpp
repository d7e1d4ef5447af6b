// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <render/renderer.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace oroforge::render {
namespace {

using nlohmann::json;

std::string rendered(const std::string& text, const json& view, const std::string& partial = "") {
    Templates templates;
    templates.add("t", text);
    templates.add("p", partial);
    return Renderer(templates).render("t", view);
}

std::string failure(const std::string& text, const json& view) {
    try {
        rendered(text, view);
    } catch (const RenderError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Renderer, EscapesNothing) { EXPECT_EQ(rendered("{{x}}|{{{x}}}", {{"x", "<\"&>"}}), "<\"&>|<\"&>"); }

TEST(Renderer, WritesNumbers) { EXPECT_EQ(rendered("{{i}} {{d}}", {{"i", -3}, {"d", 0.5}}), "-3 0.5"); }

TEST(Renderer, UnknownKeyIsAnError) {
    EXPECT_EQ(failure("{{name}} {{nmae}}", {{"name", "x"}}), "t: no key 'nmae' in the view");
}

TEST(Renderer, ListAsVariableIsAnError) {
    EXPECT_EQ(failure("{{x}}", {{"x", {1, 2}}}), "t: key 'x' is not a string or number");
}

TEST(Renderer, UnknownPartialAndTemplateAreErrors) {
    EXPECT_EQ(failure("{{> q}}", json::object()), "t: no partial 'q'");
    EXPECT_THROW(Renderer(Templates{}).render("t", json::object()), RenderError);
}

TEST(Renderer, UnclosedSectionIsAnError) { EXPECT_NE(failure("{{#a}}x", {{"a", true}}), "no error"); }

TEST(Renderer, AbsentNullFalseAndEmptyAreNotPresent) {
    const std::string text = "{{#x}}yes{{/x}}{{^x}}no{{/x}}";

    EXPECT_EQ(rendered(text, json::object()), "no");
    EXPECT_EQ(rendered(text, {{"x", nullptr}}), "no");
    EXPECT_EQ(rendered(text, {{"x", false}}), "no");
    EXPECT_EQ(rendered(text, {{"x", ""}}), "no");
    EXPECT_EQ(rendered(text, {{"x", json::array()}}), "no");
    EXPECT_EQ(rendered(text, {{"x", 0}}), "yes");
    EXPECT_EQ(rendered(text, {{"x", "text"}}), "yes");
}

TEST(Renderer, InnerNullHidesOuterKey) {
    const json view = {{"doc", "outer"}, {"items", json::array({json{{"doc", nullptr}}, json{{"doc", "inner"}}})}};

    EXPECT_EQ(rendered("{{#items}}[{{#doc}}{{.}}{{/doc}}]{{/items}}", view), "[][inner]");
}

TEST(Renderer, ListsOfTextsAreReachedByDot) {
    EXPECT_EQ(rendered("{{#x}}<{{.}}>{{/x}}", {{"x", {"a", "b"}}}), "<a><b>");
}

TEST(Renderer, LinesOfTagsAloneLeaveNoTrace) {
    const std::string text = "a\n{{#x}}\nb\n{{/x}}\n{{! comment }}\n{{#y}}\n\nc\n{{/y}}\nd\n";

    EXPECT_EQ(rendered(text, {{"x", true}, {"y", false}}), "a\nb\nd\n");
    EXPECT_EQ(rendered(text, {{"x", false}, {"y", true}}), "a\n\nc\nd\n");
}

TEST(Renderer, PartialsSeeTheContext) {
    EXPECT_EQ(rendered("a\n{{> p}}\nb\n", {{"x", "1"}}, "[{{x}}]\n"), "a\n[1]\nb\n");
}

TEST(Renderer, LeadingCommentIsNotOutput) { EXPECT_EQ(rendered("{{! what\n this is }}\na\n", json::object()), "a\n"); }

TEST(Renderer, ValuesAreNotTemplates) { EXPECT_EQ(rendered("{{x}}", {{"x", "{{y}}"}}), "{{y}}"); }

}  // namespace
}  // namespace oroforge::render
