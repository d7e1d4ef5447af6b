// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Writing into a property file that exists changes the values in it, and nothing else.
#include "cpf_fixture.hpp"

#include <cpf/cpf_reader.hpp>
#include <cpf/cpf_writer.hpp>
#include <cpf/property_file.hpp>
#include <rtt/types/TemplateTypeInfo.hpp>

using namespace RTT;
using namespace RTT::marsh;
using namespace types_test;

namespace {

struct Numbers {
    std::vector<double> values;
};

/** Composed by order from members whose names are made of `prefix`; the type itself has none. */
class NumbersInfo : public types::TemplateTypeInfo<Numbers> {
public:
    explicit NumbersInfo(const std::string& prefix)
        : types::TemplateTypeInfo<Numbers>("test.Numbers"), prefix_(prefix) {}

    bool decomposeTypeImpl(const Numbers& source, PropertyBag& target) const override {
        for (std::size_t i = 0; i != source.values.size(); ++i)
            target.ownProperty(new Property<double>(prefix_ + std::to_string(i), "", source.values[i]));
        return true;
    }
    bool composeTypeImpl(const PropertyBag& source, Numbers& target) const override {
        target.values.clear();
        for (auto* item : source) target.values.push_back(Property<double>(item).get());
        return true;
    }

private:
    std::string prefix_;
};

class CpfEdit : public Cpf {
protected:
    /** What becomes of a file with this body; only the body is returned. */
    std::string edited(const std::string& body, SaveMode mode) {
        put(body);
        EXPECT_TRUE(saveToFile(bag, file, mode, sink)) << said();
        const std::string all = get();
        PropertyBag read;
        EXPECT_TRUE(readFile(file, read, sink)) << said() << all;
        const auto begin = all.find("<properties>\n") + 13;
        return all.substr(begin, all.rfind("\n</properties>") - begin);
    }
    std::string updated(const std::string& body) { return edited(body, SaveMode::update); }
    std::string merged(const std::string& body) { return edited(body, SaveMode::merge); }

    template <class T>
    void own(const std::string& name, const T& value, const std::string& description = "") {
        bag.ownProperty(new Property<T>(name, description, value));
    }
    /** What a component with a default value gets from the file. */
    template <class T>
    T loaded(const std::string& name) {
        PropertyBag component;
        auto* property = new Property<T>(name);
        component.ownProperty(property);
        EXPECT_TRUE(loadFromFile(component, file, LoadMode::strictRefresh, sink)) << said() << get();
        return property->get();
    }
};

}  // namespace

TEST_F(CpfEdit, CommentsUnknownElementsAndLayoutSurvive) {
    own("a", 2);
    own("b", std::string("x < y"));
    own("none", 1);
    EXPECT_EQ(
        "  <!-- of a -->\n"
        "  <simple  type='long' extra=\"1\"\n     name='a'>\n"
        "    <!-- value --><value><!-- old -->2</value> <choices><choice>1</choice></choices></simple>\n\n"
        "  <theirs><simple name=\"b\" type=\"string\"><value>x &lt; y</value></simple></theirs><!-- end -->",
        updated("  <!-- of a -->\n"
                "  <simple  type='long' extra=\"1\"\n     name='a'>\n"
                "    <!-- value --><value><!-- old -->2</value> <choices><choice>1</choice></choices></simple>\n\n"
                "  <theirs><simple name=\"b\" type=\"string\"><value/></simple></theirs><!-- end -->"));
}

TEST_F(CpfEdit, ValuesThatAreTheSameKeepTheirSpelling) {
    own("d", 1.5);
    own("s", 3);
    own("t", true);
    const std::string body =
        "<simple name=\"d\" type=\"double\"><value> +1.500 </value></simple>"
        "<simple name=\"s\" type=\"short\"><value>03</value></simple>"
        "<simple name=\"t\" type=\"boolean\"><value>true</value></simple>";
    EXPECT_EQ(body, merged(body));
}

TEST_F(CpfEdit, TypesFollowTheComponent) {
    own("p", 0.5);
    EXPECT_EQ(simple("double", "0.5"), updated(simple("long", "3")));
}

TEST_F(CpfEdit, SimpleAndStructReplaceEachOther) {
    PropertyBag inner;
    inner.ownProperty(new Property<int>("x", "", 1));
    own("s", inner);
    own("p", 4);
    EXPECT_EQ(
        "  <struct name=\"s\" type=\"PropertyBag\">\n"
        "     <simple name=\"x\" type=\"long\"><value>1</value></simple>\n"
        "  </struct>\n"
        "  <simple name=\"p\" type=\"long\"><value>4</value></simple>",
        updated("  <simple name=\"s\" type=\"long\"><value>1</value></simple>\n"
                "  <struct name=\"p\" type=\"PropertyBag\">\n  </struct>"));
}

TEST_F(CpfEdit, NewPropertiesStandBehindTheOthers) {
    own("a", 1);
    own("b", 2, "new");
    PropertyBag inner;
    inner.ownProperty(new Property<int>("x", "", 1));
    own("s", inner);
    own("e", inner);
    EXPECT_EQ(
        "    <simple name=\"a\" type=\"long\"><value>1</value></simple>\n"
        "    <struct name=\"s\" type=\"PropertyBag\">\n      <!-- empty -->\n"
        "       <simple name=\"x\" type=\"long\"><value>1</value></simple>\n    </struct>\n"
        "    <struct name=\"e\" type=\"PropertyBag\" >\n"
        "       <simple name=\"x\" type=\"long\"><value>1</value></simple>\n    </struct>\n"
        "    <!-- last -->\n"
        "    <simple name=\"b\" type=\"long\"><description>new</description><value>2</value></simple>",
        merged("    <simple name=\"a\" type=\"long\"><value>1</value></simple>\n"
               "    <struct name=\"s\" type=\"PropertyBag\">\n      <!-- empty -->\n    </struct>\n"
               "    <struct name=\"e\" type=\"PropertyBag\" />\n"
               "    <!-- last -->"));
}

TEST_F(CpfEdit, FilesWithoutPropertiesGetThem) {
    own("a", 1);
    for (const char* text : {"<properties/>", "<properties></properties>", "<properties>\n</properties>"}) {
        putText(text);
        ASSERT_TRUE(saveToFile(bag, file, SaveMode::merge, sink)) << said();
        EXPECT_EQ("<properties>\n  <simple name=\"a\" type=\"long\"><value>1</value></simple>\n</properties>", get());
    }
}

TEST_F(CpfEdit, LineEndsOfTheFileAreUsed) {
    own("a", 1);
    putText("<properties>\r\n</properties>\r\n");
    ASSERT_TRUE(saveToFile(bag, file, SaveMode::merge, sink));
    EXPECT_EQ("<properties>\r\n  <simple name=\"a\" type=\"long\"><value>1</value></simple>\r\n</properties>\r\n",
              get());
}

TEST_F(CpfEdit, TabsOfTheFileAreUsed) {
    PropertyBag inner;
    inner.ownProperty(new Property<int>("b", "", 2));
    own("a", 1);
    bag.ownProperty(new Property<PropertyBag>("s", "", inner));
    putText("<properties>\n\t<simple name=\"a\" type=\"long\">\n\t\t<value>0</value>\n\t</simple>\n</properties>\n");
    EXPECT_TRUE(saveToFile(bag, file, SaveMode::merge, sink)) << said();
    EXPECT_EQ(
        "<properties>\n\t<simple name=\"a\" type=\"long\">\n\t\t<value>1</value>\n\t</simple>\n"
        "\t<struct name=\"s\" type=\"PropertyBag\">\n"
        "\t\t<simple name=\"b\" type=\"long\"><value>2</value></simple>\n\t</struct>\n</properties>\n",
        get());
}

TEST_F(CpfEdit, DescriptionsAreAddedButNotReplaced) {
    own("p", 1, "mine");
    EXPECT_EQ("<simple name=\"p\" type=\"long\"><description>mine</description><value>1</value></simple>",
              merged(simple("long", "1")));
    const std::string theirs =
        "<simple name=\"p\" type=\"long\"><description>theirs</description><value>1</value></simple>";
    EXPECT_EQ(theirs, merged(theirs));
    EXPECT_EQ(simple("long", "1"), updated(simple("long", "1")));
}

TEST_F(CpfEdit, SequencesGetTheirLength) {
    own("v", std::vector<double>{1, 2});
    EXPECT_EQ(
        "<sequence name=\"v\" type=\"array\">\n"
        "  <simple type=\"double\"><value>1</value></simple> <!-- first -->\n"
        "  <simple type=\"double\"><value>2</value></simple>\n</sequence>",
        updated("<sequence name=\"v\" type=\"array\">\n"
                "  <simple type=\"double\"><value>1.5</value></simple> <!-- first -->\n"
                "  <simple type=\"double\"><value>2</value></simple>\n"
                "  <simple type=\"double\"><value>3</value></simple>\n</sequence>"));
    EXPECT_EQ(
        "<struct name=\"v\" type=\"array\"><simple name=\"a\" type=\"double\"><value>1</value></simple>\n"
        "   <simple name=\"Element1\" type=\"double\"><description>Sequence "
        "Element</description><value>2</value></simple>\n"
        "</struct>",
        updated("<struct name=\"v\" type=\"array\"><simple name=\"a\" "
                "type=\"double\"><value>4</value></simple></struct>"));
    bag.getPropertyType<std::vector<double>>("v")->set({});
    EXPECT_EQ(
        "<struct name=\"v\" type=\"array\"></struct>",
        updated("<struct name=\"v\" type=\"array\">\n  <simple type=\"double\"><value>4</value></simple></struct>"));
}

TEST_F(CpfEdit, StructsGetAllTheirMembers) {
    own("at", sample::Point{1, 2});
    const std::string head = "<struct name=\"at\" type=\"sample.Point\"><!-- c -->";
    const auto member = [](const std::string& name, const std::string& value, const std::string& description = "") {
        return "<simple name=\"" + name + "\" type=\"double\">" + description + "<value>" + value + "</value></simple>";
    };
    const std::string east = "<description>east [m]</description>", north = "<description>north [m]</description>";
    for (const auto mode : {SaveMode::update, SaveMode::merge}) {
        EXPECT_EQ(head + member("x", "1") + "\n   " + member("y", "2", north) + "\n</struct>",
                  edited(head + member("x", "1") + "</struct>", mode));
        EXPECT_EQ(head + "\n   " + member("x", "1", east) + "\n   " + member("y", "2", north) + "\n</struct>",
                  edited(head + member("y", "0") + "</struct>", mode))
            << "in the order of the type";
        EXPECT_EQ(head + member("x", "1") + member("y", "2.0") + "</struct>",
                  edited(head + member("x", "0") + member("y", "2.0") + member("z", "3") + "</struct>", mode))
            << "and no others";
        EXPECT_EQ(2, loaded<sample::Point>("at").y);
    }
}

TEST_F(CpfEdit, StructsKeepTheOrderOfTheFile) {
    own("at", sample::Point{1, 2});
    const std::string x = "<simple name=\"x\" type=\"double\"><value>1</value></simple>";
    const std::string y = "<simple name=\"y\" type=\"double\"><value>2.0</value></simple>";
    const std::string body = "<struct name=\"at\" type=\"sample.Point\">" + y + "<!-- c -->" + x + "</struct>";
    EXPECT_EQ(body, updated(body));
}

TEST_F(CpfEdit, OtherTypesGetTheirMembers) {
    own("at", sample::Point{1, 2});
    for (const char* open : {"struct name=\"at\" type=\"sample.Tank\"", "struct name=\"at\" type=\"PropertyBag\"",
                             "sequence name=\"at\" type=\"array\""}) {
        const std::string tag = std::string(open).substr(0, std::string(open).find(' '));
        EXPECT_EQ(
            "<" + tag +
                " name=\"at\" type=\"/sample/Point\">\n"
                "  <simple name=\"x\" type=\"double\"><description>east [m]</description><value>1</value></simple>\n"
                "  <simple name=\"y\" type=\"double\"><description>north [m]</description><value>2</value></simple>\n"
                "</" +
                tag + ">",
            updated("<" + std::string(open) + ">\n  <simple name=\"id\" type=\"double\"><value>1</value></simple>\n</" +
                    tag + ">"));
        EXPECT_EQ(2, loaded<sample::Point>("at").y);
    }
}

TEST_F(CpfEdit, ComposedValuesGetTheirLength) {
    for (const char* prefix : {"", "Element", "n"}) {
        types::Types()->addType(new NumbersInfo(prefix));
        bag.clear();
        own("n", Numbers{{1, 2, 3, 4, 5}});
        ASSERT_TRUE(saveToFile(bag, file, SaveMode::store, sink)) << said();
        for (const auto& values : {std::vector<double>{6, 7, 8}, {}, {9, 10}}) {
            bag.getPropertyType<Numbers>("n")->set(Numbers{values});
            ASSERT_TRUE(saveToFile(bag, file, SaveMode::update, sink)) << said();
            EXPECT_EQ(cpfText(bag), get());
            EXPECT_EQ(values, loaded<Numbers>("n").values);
        }
    }
}

TEST_F(CpfEdit, ComposedValuesGetTheirOrder) {
    types::Types()->addType(new NumbersInfo(""));
    own("n", Numbers{{1, 2}});
    EXPECT_EQ(
        "<struct name=\"n\" type=\"test.Numbers\"><!-- c -->\n"
        "   <simple name=\"0\" type=\"double\"><value>1</value></simple>\n"
        "   <simple name=\"1\" type=\"double\"><value>2</value></simple>\n</struct>",
        updated("<struct name=\"n\" type=\"test.Numbers\"><!-- c -->\n"
                "   <simple name=\"1\" type=\"double\"><value>2</value></simple>\n"
                "   <simple name=\"0\" type=\"double\"><value>1</value></simple>\n</struct>"));
    EXPECT_EQ((std::vector<double>{1, 2}), loaded<Numbers>("n").values);
}

TEST_F(CpfEdit, TypeNamesAreKeptIfTheyMeanTheSame) {
    own("v", std::vector<double>{1});
    const std::string body =
        "<struct name=\"v\" type=\"std.vector&lt;double&gt;\"><simple "
        "type=\"double\"><value>1</value></simple></struct>";
    EXPECT_EQ(body, merged(body));
    EXPECT_EQ("<struct name=\"v\" type=\"array\"><simple type=\"double\"><value>1</value></simple></struct>",
              merged("<struct name=\"v\" type=\"strings\"><simple type=\"double\"><value>1</value></simple></struct>"));
}

TEST_F(CpfEdit, EqualNamesArePairedInOrder) {
    own("p", 1);
    own("p", 2);
    EXPECT_EQ(simple("long", "1") + simple("long", "2") + simple("long", "9"),
              merged(simple("long", "7") + simple("long", "8") + simple("long", "9")));
}

TEST_F(CpfEdit, OnePropertyInABag) {
    storeProperty(bag, "s", new Property<int>("x", "", 5));
    storeProperty(bag, "s", new Property<int>("y", "", 6));
    put("<struct name=\"s\" type=\"PropertyBag\"><!-- c -->\n</struct>");
    ASSERT_TRUE(saveOneToFile(bag, file, "s.y", sink)) << said();
    EXPECT_NE(std::string::npos, get().find("<struct name=\"s\" type=\"PropertyBag\"><!-- c -->\n   <simple name=\"y\" "
                                            "type=\"long\"><value>6</value></simple>\n</struct>"))
        << get();
}

TEST_F(CpfEdit, NamesWithDotsAreFoundFirst) {
    own("a.b", 7);
    ASSERT_TRUE(saveOneToFile(bag, file, "a.b", sink));
    EXPECT_NE(std::string::npos, get().find("<simple name=\"a.b\" type=\"long\"><value>7</value></simple>")) << get();
}

TEST_F(CpfEdit, FilesWithWrongValuesAreLeftAlone) {
    own("p", 1);
    put(simple("long", "x"));
    const std::string before = get();
    EXPECT_FALSE(saveToFile(bag, file, SaveMode::update, sink));
    EXPECT_EQ(before, get());
    EXPECT_EQ("test.cpf:4:37: error: [CPF006] property 'p' of type long cannot be 'x'; expected a whole number\n",
              said());
}
