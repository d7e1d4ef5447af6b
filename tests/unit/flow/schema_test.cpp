// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How two descriptions of a type are compared.
#include <rtt/types/Schema.hpp>

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

using namespace RTT::types;

namespace {

const Schema& inner() {
    static constexpr SchemaField fields[] = {{"u", "float", 0, "", nullptr}};
    static constexpr Schema schema = {"Inner", 4, 4, fields, 1, false};
    return schema;
}
const Schema& innerMoved() {
    static constexpr SchemaField fields[] = {{"u", "float", 32, "", nullptr}};
    static constexpr Schema schema = {"Inner", 8, 4, fields, 1, false};
    return schema;
}
/** A node that has a list of nodes. */
const Schema& node() {
    static constexpr SchemaField fields[] = {{"children", "std::vector<Node>", 0, "", &node}};
    static constexpr Schema schema = {"Node", 24, 8, fields, 1, false};
    return schema;
}
const Schema& otherNode() {
    static constexpr SchemaField fields[] = {{"children", "std::vector<Node>", 0, "", &otherNode}};
    static constexpr Schema schema = {"Node", 24, 8, fields, 1, false};
    return schema;
}

std::string difference(const Schema& a, const Schema& b) { return schemaDifference(a, b, "here", "there"); }

const SchemaField kFields[] = {{"a", "int", 0, "", nullptr}, {"b", "Inner", 32, "", &inner}};
const Schema kBase = {"S", 8, 4, kFields, 2, false};

}  // namespace

TEST(Schema, NamesAFieldOnlyOneSideHas) {
    const Schema shorter = {"S", 4, 4, kFields, 1, false};
    EXPECT_EQ(difference(kBase, shorter), "field 'b' is there only here");
    EXPECT_EQ(difference(shorter, kBase), "field 'b' is there only there");
    const SchemaField inserted[] = {{"n", "int", 0, "", nullptr}, kFields[0], kFields[1]};
    EXPECT_EQ(difference(kBase, {"S", 12, 4, inserted, 3, false}), "field 'n' is there only there");
}

TEST(Schema, DescendsToTheFieldThatMoved) {
    const SchemaField fields[] = {kFields[0], {"b", "Inner", 32, "", &innerMoved}};
    EXPECT_EQ(difference(kBase, {"S", 8, 4, fields, 2, false}), "field 'b.u' is at byte 0 here, byte 4 there");
}

TEST(Schema, TellsBitsAndAlignment) {
    const SchemaField one[] = {{"a", "int : 3", 3, "", nullptr}}, other[] = {{"a", "int : 3", 5, "", nullptr}};
    EXPECT_EQ(difference({"S", 4, 4, one, 1, false}, {"S", 4, 4, other, 1, false}),
              "field 'a' is at bit 3 here, bit 5 there");
    EXPECT_EQ(difference({"S", 8, 4, kFields, 2, false}, {"S", 8, 8, kFields, 2, false}),
              "the type is aligned to 4 bytes here, 8 bytes there");
}

TEST(Schema, IgnoresAUnitThatOnlyOneSideKnows) {
    const SchemaField fields[] = {{"a", "int", 0, "m", nullptr}, kFields[1]};
    EXPECT_EQ(difference(kBase, {"S", 8, 4, fields, 2, false}), "");
}

TEST(Schema, TellsEnumeratorsThatGotAnotherName) {
    const SchemaField one[] = {{"Red", "", 0, "", nullptr}}, other[] = {{"Blue", "", 0, "", nullptr}};
    EXPECT_EQ(difference({"E", 4, 4, one, 1, true}, {"E", 4, 4, other, 1, true}),
              "enumerator 'Red' (0) is called 'Red' here, 'Blue' there");
}

TEST(Schema, EndsForTypesThatContainThemselves) {
    EXPECT_EQ(difference(node(), otherNode()), "");
    EXPECT_EQ(layoutHash(node()), layoutHash(otherNode()));
}

TEST(Schema, HashesTellPlacesAndNamesApart) {
    const SchemaField renamed[] = {{"z", "int", 0, "", nullptr}, kFields[1]};
    const SchemaField moved[] = {{"a", "int", 32, "", nullptr}, {"b", "Inner", 0, "", &inner}};
    const Schema other = {"S", 8, 4, renamed, 2, false}, swapped = {"S", 8, 4, moved, 2, false};
    EXPECT_EQ(layoutHash(kBase), layoutHash(other));
    EXPECT_NE(schemaHash(kBase), schemaHash(other));
    EXPECT_NE(layoutHash(kBase), layoutHash(swapped));
    EXPECT_EQ(schemaHash(kBase), schemaHash(swapped));
}

TEST(Schema, KnowsElementsOfContainers) {
    const Schema& map = schemaOf<std::map<std::string, std::vector<long>>>();
    ASSERT_EQ(map.count, 1u);
    const Schema& entry = map.fields[0].of();
    ASSERT_EQ(entry.count, 2u);
    EXPECT_STREQ(entry.fields[1].name, "second");
    EXPECT_EQ(entry.fields[1].of().fields[0].of().size, sizeof(long));
}
