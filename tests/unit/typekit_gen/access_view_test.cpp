// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <plan/access_view.hpp>

#include <gtest/gtest.h>

#include <render/renderer.hpp>

using namespace oroforge;
using model::AccessKind;

namespace oroforge::embedded {
diag::EmbeddedFiles typekitTemplates();
}

namespace {

struct Statements {
    std::string load, store;
};

Statements statementsOf(const model::FieldAccess& access) {
    const render::Renderer renderer{render::Templates(embedded::typekitTemplates())};
    const auto render = [&](const char* name) {
        const std::string text = renderer.render(name, typekit::accessView(access));
        const std::size_t begin = text.find_first_not_of(' ');
        return begin == std::string::npos ? "" : text.substr(begin, text.find('\n') - begin);
    };
    return {render("typekit/access_load"), render("typekit/access_store")};
}

void expectStatements(const model::FieldAccess& access, const std::string& load, const std::string& store) {
    const Statements made = statementsOf(access);
    EXPECT_EQ(made.load, load) << model::word(access.kind);
    EXPECT_EQ(made.store, store) << model::word(access.kind);
}

}  // namespace

TEST(AccessView, HasAStatementForEachKindOfMember) {
    expectStatements({AccessKind::Copy, "m", "m"}, "value = object.m;", "object.m = value;");
    expectStatements({AccessKind::Bytes, "m", "m"}, "std::memcpy(&value, &object.m, sizeof value);",
                     "std::memcpy(&object.m, &value, sizeof value);");
    expectStatements({AccessKind::Packed, "m", "m", 5},
                     "std::memcpy(&value, reinterpret_cast<const char*>(&object) + 5, sizeof value);",
                     "std::memcpy(reinterpret_cast<char*>(&object) + 5, &value, sizeof value);");
    expectStatements({AccessKind::EnumBits, "m", "m"}, "value = object.m;",
                     "object.m = static_cast<decltype(object.m)>(value);");
    expectStatements({AccessKind::Text, "m", "m", 8}, "value.assign(&object.m[0], ::strnlen(&object.m[0], 8));",
                     "std::memset(&object.m[0], 0, 8), value.copy(&object.m[0], 8 - 1);");
    expectStatements({AccessKind::Atomic, "m", "m"}, "value = object.m.load();", "object.m.store(value);");
}

TEST(AccessView, MakesANewObjectForAPointer) {
    const std::string load = "value = object.p ? std::make_optional(*object.p) : std::nullopt;";
    expectStatements({AccessKind::Shared, "p", "p", 0, "const ::P"}, load,
                     "if (value) object.p = std::make_shared<const ::P>(*value); else object.p = nullptr;");
    expectStatements({AccessKind::Unique, "p", "p", 0, "::P"}, load,
                     "if (value) object.p = std::make_unique<::P>(*value); else object.p = nullptr;");
}

TEST(AccessView, TakesTheFirstPartOfATupleToo) {
    expectStatements({AccessKind::Part, "0", "0"}, "value = std::get<0>(object);", "std::get<0>(object) = value;");
}

TEST(AccessView, AssignsToWhatAFunctionReturnsOrCallsOneWithTheValue) {
    model::FieldAccess functions{AccessKind::Functions, "width", "setWidth"};
    expectStatements(functions, "value = object.width();", "object.setWidth(value);");
    functions.set = "width";
    functions.isAssigned = true;
    expectStatements(functions, "value = object.width();", "object.width() = value;");
    model::FieldAccess adapter{AccessKind::Adapter, "(row, column)", ".put(row, column, value)"};
    expectStatements(adapter, "value = object(row, column);", "object.put(row, column, value);");
    adapter.set = "[index]";
    adapter.isAssigned = true;
    expectStatements(adapter, "value = object(row, column);", "object[index] = value;");
}

TEST(AccessView, SaysNothingOfHowAConstantIsSet) {
    EXPECT_FALSE(typekit::accessView({AccessKind::Copy, "m"}).contains("set"));
}
