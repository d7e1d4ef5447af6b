// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Property files: reading, writing, and the ways between a file and a component's properties (spec 6.3, 6.4).
#include "cpf_fixture.hpp"

#include <cpf/cpf_reader.hpp>
#include <cpf/cpf_writer.hpp>
#include <cpf/property_file.hpp>
#include <rtt/marsh/PropertyDemarshaller.hpp>
#include <rtt/marsh/PropertyMarshaller.hpp>

using namespace RTT;
using namespace RTT::marsh;
using namespace types_test;

TEST_F(Cpf, ReadsEverySimpleType) {
    put("<simple name=\"b\" type=\"boolean\"><value>true</value></simple>"
        "<simple name=\"c\" type=\"char\"><value>x</value></simple>"
        "<simple name=\"o\" type=\"octet\"><value>y</value></simple>"
        "<simple name=\"s\" type=\"short\"><value>-3</value></simple>"
        "<simple name=\"us\" type=\"ushort\"><value>3</value></simple>"
        "<simple name=\"l\" type=\"long\"><value>-70000</value></simple>"
        "<simple name=\"ul\" type=\"ulong\"><value>4000000000</value></simple>"
        "<simple name=\"ll\" type=\"llong\"><value>-9000000000</value></simple>"
        "<simple name=\"ull\" type=\"ullong\"><value>18000000000000000000</value></simple>"
        "<simple name=\"f\" type=\"float\"><value>0.5</value></simple>"
        "<simple name=\"d\" type=\"double\"><value>+1e-3</value></simple>"
        "<simple name=\"t\" type=\"string\"><description>text</description><value>a &lt;b&gt; &amp; "
        "c</value></simple>");
    ASSERT_TRUE(readFile(file, bag, sink)) << said();
    EXPECT_TRUE(bag.getPropertyType<bool>("b")->get());
    EXPECT_EQ('x', bag.getPropertyType<char>("c")->get());
    EXPECT_EQ('y', bag.getPropertyType<unsigned char>("o")->get());
    EXPECT_EQ(-3, bag.getPropertyType<int>("s")->get());
    EXPECT_EQ(3u, bag.getPropertyType<unsigned int>("us")->get());
    EXPECT_EQ(-70000, bag.getPropertyType<int>("l")->get());
    EXPECT_EQ(4000000000u, bag.getPropertyType<unsigned int>("ul")->get());
    EXPECT_EQ(-9000000000, bag.getPropertyType<long long>("ll")->get());
    EXPECT_EQ(18000000000000000000u, bag.getPropertyType<unsigned long long>("ull")->get());
    EXPECT_EQ(0.5f, bag.getPropertyType<float>("f")->get());
    EXPECT_EQ(1e-3, bag.getPropertyType<double>("d")->get());
    EXPECT_EQ("a <b> & c", bag.getPropertyType<std::string>("t")->get());
    EXPECT_EQ("text", bag.find("t")->getDescription());
}

TEST_F(Cpf, AllErrorsOfAFileAreReportedWithTheirPlaces) {
    put("  <simple name=\"a\" type=\"double\"><value>x</value></simple>\n"
        "  <simple name=\"b\" type=\"real\"><value>1</value></simple>\n"
        "  <simple name=\"c\"><value>1</value></simple>\n"
        "  <simple name=\"d\" type=\"long\"/>\n"
        "  <simple name=\"e\" type=\"boolean\"><value>yes</value></simple>\n"
        "  <simple name=\"f\" type=\"long\"><value>99999999999</value></simple>\n"
        "  <simple name=\"g\" type=\"double\"><value>1.5abc</value></simple>\n"
        "  <strange/>");
    EXPECT_FALSE(readFile(file, bag, sink));
    EXPECT_EQ(
        "test.cpf:4:41: error: [CPF006] property 'a' of type double cannot be 'x'; expected a number\n"
        "test.cpf:5:26: error: [CPF005] unknown type 'real' of property 'b'; expected boolean, char, octet, short, "
        "ushort, long, ulong, llong, ullong, float, double or string\n"
        "test.cpf:6:3: error: [CPF003] <simple> has no attribute 'type'\n"
        "test.cpf:7:3: error: [CPF004] property 'd' has no <value>\n"
        "test.cpf:8:42: error: [CPF006] property 'e' of type boolean cannot be 'yes'; expected 'true', 'false', '1' or "
        "'0'\n"
        "test.cpf:9:39: error: [CPF006] property 'f' of type long cannot be '99999999999'; expected a whole number in "
        "the range of this type\n"
        "test.cpf:10:41: error: [CPF007] property 'g' of type double cannot be '1.5abc', with text after the number; "
        "expected a number\n"
        "test.cpf:11:3: warning: [CPF002] unknown element <strange> is ignored; expected simple, struct or sequence\n",
        said());
}

TEST_F(Cpf, TextBehindANumberIsAnErrorUnlessItIsToBeLeftOut) {
    for (const char* value : {"20ms", "0,02", "2.5 ", "1e", "0.5s"}) {
        put("  <simple name=\"n\" type=\"long\"><value>7</value></simple>\n  <simple name=\"g\" type=\"" +
            std::string(*value == '2' ? "long" : "double") + "\"><value>" + value + "</value></simple>");
        PropertyBag read;
        EXPECT_FALSE(readFile(file, read, sink)) << value;
        EXPECT_FALSE(read.find("g")) << value;
    }
    EXPECT_THAT(said(), testing::HasSubstr(
                            "test.cpf:5:39: error: [CPF007] property 'g' of type long cannot be '2.5', with text "
                            "after the number; expected a whole number\n"));
    const auto errors = sink.errorCount();
    put("  <simple name=\"n\" type=\"long\"><value>7.00</value></simple>");
    EXPECT_TRUE(readFile(file, bag, sink)) << "that is a whole number";
    EXPECT_EQ(7, bag.getPropertyType<int>("n")->get());
    setLenientReading(true);
    put("  <simple name=\"g\" type=\"double\"><value>20ms</value></simple>");
    EXPECT_TRUE(readFile(file, bag, sink));
    setLenientReading(false);
    EXPECT_EQ(errors, sink.errorCount());
    EXPECT_EQ(20, bag.getPropertyType<double>("g")->get());
    EXPECT_THAT(said(),
                testing::HasSubstr("warning: [CPF007] text after the number in '20ms' is ignored; the value is 20\n"));
}

TEST_F(Cpf, MissingFileAndWrongRoot) {
    EXPECT_FALSE(readFile(file, bag, sink));
    std::ofstream(file) << "<things/>";
    EXPECT_FALSE(readFile(file, bag, sink));
    EXPECT_EQ(
        "test.cpf: error: [XML001] cannot read the file: No such file or directory\n"
        "test.cpf:1:1: error: [CPF001] found <things>, expected <properties>\n",
        said());
}

TEST_F(Cpf, WritesInTheLayoutOfTheOriginal) {
    bag.ownProperty(new Property<double>("gain", "a < b", 0.1));
    bag.ownProperty(new Property<bool>("on", "", true));
    PropertyBag inner;
    inner.ownProperty(new Property<int>("n \"q\"", "", 3));
    bag.ownProperty(new Property<PropertyBag>("s", "inner", inner));
    EXPECT_EQ(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE properties SYSTEM \"cpf.dtd\">\n<properties>\n"
        "  <simple name=\"gain\" type=\"double\"><description>a &lt; b</description><value>0.1</value></simple>\n"
        "  <simple name=\"on\" type=\"boolean\"><value>1</value></simple>\n"
        "  <struct name=\"s\" type=\"PropertyBag\">\n"
        "     <description>inner</description>\n"
        "     <simple name=\"n &quot;q&quot;\" type=\"long\"><value>3</value></simple>\n"
        "  </struct>\n"
        "</properties>\n",
        cpfText(bag));
}

TEST_F(Cpf, WriteReadWriteIsAFixedPoint) {
    sample::Tank tank;
    tank.label = "a & b";
    tank.levels = {0.1, 1e300, -0.0};
    tank.path = {{1, 2}};
    tank.mode = sample::Mode::Filling;
    tank.small = 255;
    tank.flags = {true, false};
    bag.ownProperty(new Property<sample::Tank>("tank", "of a test", tank));
    bag.ownProperty(new Property<float>("f", "", 0.1f));
    bag.ownProperty(new Property<std::string>("empty", "", ""));
    const std::string first = cpfText(bag);
    ASSERT_TRUE(writeFile(file, first));
    PropertyBag target;
    target.ownProperty(new Property<sample::Tank>("tank", "of a test"));
    ASSERT_TRUE(loadFromFile(target, file, LoadMode::load, sink)) << said();
    EXPECT_EQ(first, cpfText(target));
    EXPECT_EQ(variable(tank)->toString(), target.find("tank")->getDataSource()->toString());
    EXPECT_NE(std::string::npos, first.find("<simple name=\"mode\" type=\"string\"><description>Part</description>"
                                            "<value>Filling</value></simple>"))
        << first;
}

TEST_F(Cpf, SequenceElementsBecomeSequences) {
    put("<sequence name=\"p\" type=\"whatever\"><simple type=\"double\"><value>1</value></simple>"
        "<simple type=\"double\"><value>2</value></simple></sequence>");
    bag.ownProperty(new Property<std::vector<double>>("p", ""));
    ASSERT_TRUE(loadFromFile(bag, file, LoadMode::refresh, sink)) << said();
    EXPECT_EQ((std::vector<double>{1, 2}), bag.getPropertyType<std::vector<double>>("p")->get());
}

TEST_F(Cpf, TypedStructsBecomeValuesOfTheirType) {
    put("<struct name=\"at\" type=\"sample.Point\"><simple name=\"y\" "
        "type=\"double\"><value>3</value></simple></struct>");
    ASSERT_TRUE(loadFromFile(bag, file, LoadMode::load, sink)) << said();
    auto* point = bag.getPropertyType<sample::Point>("at");
    ASSERT_NE(nullptr, point);
    EXPECT_EQ(3, point->get().y);
}

TEST_F(Cpf, LoadCreatesUpdateDoesNotAndReadNeedsAll) {
    put("<simple name=\"p\" type=\"long\"><value>5</value></simple><simple name=\"q\" "
        "type=\"long\"><value>6</value></simple>");
    bag.ownProperty(new Property<int>("p", "", 1));
    ASSERT_TRUE(loadFromFile(bag, file, LoadMode::refresh, sink));
    EXPECT_EQ(1u, bag.size());
    ASSERT_TRUE(loadFromFile(bag, file, LoadMode::load, sink));
    EXPECT_EQ(2u, bag.size());
    EXPECT_TRUE(loadFromFile(bag, file, LoadMode::strictRefresh, sink));
    bag.ownProperty(new Property<int>("r", "", 1));
    EXPECT_FALSE(loadFromFile(bag, file, LoadMode::strictRefresh, sink));
    EXPECT_EQ("test.cpf: error: [CPF020] property 'r' of type " + bag.find("r")->getType() + " is missing\n", said());
}

TEST_F(Cpf, FailedLoadRestoresEverything) {
    put("<simple name=\"p\" type=\"long\"><value>5</value></simple>\n"
        "<struct name=\"s\" type=\"PropertyBag\"><simple name=\"x\" "
        "type=\"double\"><value>9</value></simple></struct>\n"
        "<simple name=\"new\" type=\"long\"><value>5</value></simple>\n"
        "<simple name=\"q\" type=\"string\"><value>5</value></simple>");
    double x = 1;
    PropertyBag inner;
    inner.addProperty("x", x);
    bag.ownProperty(new Property<int>("p", "", 1));
    bag.ownProperty(new Property<PropertyBag>("s", ""));
    bag.getPropertyType<PropertyBag>("s")->value().addProperty("x", x);
    bag.ownProperty(new Property<int>("q", "", 2));
    EXPECT_FALSE(loadFromFile(bag, file, LoadMode::load, sink));
    EXPECT_EQ("test.cpf:7:1: error: [CPF020] property 'q' of type int cannot take a value of type string\n", said());
    EXPECT_EQ(1, bag.getPropertyType<int>("p")->get());
    EXPECT_EQ(1, x);
    EXPECT_EQ(nullptr, bag.find("new"));
}

TEST_F(Cpf, MismatchesAreReportedWithPathAndPlace) {
    put("<struct name=\"s\" type=\"PropertyBag\">\n"
        "  <struct name=\"t\" type=\"sample.Tank\">\n"
        "    <simple name=\"id\" type=\"string\"><value>x</value></simple>\n"
        "    <struct name=\"position\" type=\"sample.Point\">\n"
        "      <simple name=\"y\" type=\"string\"><value>x</value></simple></struct>\n"
        "    <struct name=\"path\" type=\"PropertyBag\"><struct type=\"sample.Point\"/>\n"
        "      <simple type=\"double\"><value>1</value></simple></struct>\n"
        "  </struct>\n"
        "  <simple name=\"q\" type=\"string\"><value>x</value></simple></struct>");
    storeProperty(bag, "s", new Property<sample::Tank>("t", ""));
    storeProperty(bag, "s", new Property<double>("q", "", 1));
    EXPECT_FALSE(loadFromFile(bag, file, LoadMode::refresh, sink));
    EXPECT_EQ(
        "test.cpf:6:5: error: [CPF020] property 's.t.id' of type int cannot take a value of type string\n"
        "test.cpf:8:7: error: [CPF020] property 's.t.position.y' of type double cannot take a value of type string\n"
        "test.cpf:10:7: error: [CPF020] property 's.t.path.1' of type /sample/Point cannot take a value of type "
        "double\n"
        "test.cpf:12:3: error: [CPF020] property 's.q' of type double cannot take a value of type string\n",
        said());
}

TEST_F(Cpf, DescriptionsAreRestoredToo) {
    put(simple("string", "x") +
        "<simple name=\"q\" type=\"long\"><description>d</description><value>5</value></simple>");
    bag.ownProperty(new Property<int>("q", "", 1));
    bag.ownProperty(new Property<int>("p", "", 1));
    EXPECT_FALSE(loadFromFile(bag, file, LoadMode::load, sink));
    EXPECT_EQ("", bag.find("q")->getDescription());
    EXPECT_EQ(1, bag.getPropertyType<int>("q")->get());
}

TEST_F(Cpf, DtdIsNotLookedFor) {
    putText("<!DOCTYPE properties SYSTEM \"http://nowhere.invalid/no.dtd\"><properties/>");
    EXPECT_TRUE(readFile(file, bag, sink)) << said();
}

TEST_F(Cpf, UnknownStructTypeIsAnError) {
    put("<struct name=\"p\" type=\"NoSuchType\"/>");
    EXPECT_FALSE(loadFromFile(bag, file, LoadMode::load, sink));
    EXPECT_EQ(
        "test.cpf:4:1: error: [CPF020] property 'p' cannot be made: type NoSuchType is not known to any typekit\n",
        said());
}

TEST_F(Cpf, OneProperty) {
    put("<struct name=\"s\" type=\"PropertyBag\">" + simple("long", "7") + "</struct>");
    storeProperty(bag, "s", new Property<int>("p", "", 1));
    EXPECT_TRUE(loadOneFromFile(bag, file, "s.p", sink));
    EXPECT_EQ(7, Property<int>(findProperty(bag, "s.p")).get());
    EXPECT_FALSE(loadOneFromFile(bag, file, "s.q", sink));
    EXPECT_EQ(
        "error: [CPF022] there is no property 's.q' to read\n"
        "test.cpf: error: [CPF021] property 's.q' is not in the file\n",
        said());
}

TEST_F(Cpf, MergeKeepsWhatTheFileHasAndUpdateAddsNothing) {
    put("<simple name=\"theirs\" type=\"long\"><value>1</value></simple><simple name=\"both\" "
        "type=\"long\"><value>1</value></simple>");
    bag.ownProperty(new Property<int>("both", "", 2));
    bag.ownProperty(new Property<int>("mine", "", 3));
    ASSERT_TRUE(saveToFile(bag, file, SaveMode::update, sink)) << said();
    EXPECT_NE(std::string::npos, get().find("theirs"));
    EXPECT_NE(std::string::npos, get().find("<simple name=\"both\" type=\"long\"><value>2</value>"));
    EXPECT_EQ(std::string::npos, get().find("mine"));
    ASSERT_TRUE(saveToFile(bag, file, SaveMode::merge, sink));
    EXPECT_NE(std::string::npos, get().find("mine"));
    ASSERT_TRUE(saveToFile(bag, file, SaveMode::store, sink));
    EXPECT_EQ(std::string::npos, get().find("theirs"));
}

TEST_F(Cpf, UnreadableFileIsLeftAloneWhenMerging) {
    std::ofstream(file) << "<properties><broken</properties>";
    bag.ownProperty(new Property<int>("p", "", 2));
    EXPECT_FALSE(saveToFile(bag, file, SaveMode::merge, sink));
    EXPECT_EQ("<properties><broken</properties>", get());
}

TEST_F(Cpf, OnePropertyIsAddedToTheFile) {
    put(simple("long", "1"));
    storeProperty(bag, "s", new Property<double>("x", "", 0.5));
    ASSERT_TRUE(saveOneToFile(bag, file, "s.x", sink)) << said();
    PropertyBag read;
    ASSERT_TRUE(readFile(file, read, sink));
    EXPECT_NE(nullptr, findProperty(read, "s.x"));
    EXPECT_NE(nullptr, read.find("p"));
    EXPECT_FALSE(saveOneToFile(bag, file, "s.y", sink));
}

TEST_F(Cpf, FolderThatDoesNotExistIsAnError) { EXPECT_FALSE(writeFile((folder / "no" / "such.cpf").string(), "x")); }

TEST_F(Cpf, MarshallerAndDemarshaller) {
    bag.ownProperty(new Property<int>("p", "", 2));
    { PropertyMarshaller(file).serialize(bag); }
    PropertyBag read;
    EXPECT_TRUE(PropertyDemarshaller(file).deserialize(read));
    EXPECT_EQ(2, read.getPropertyType<int>("p")->get());
    EXPECT_FALSE(PropertyDemarshaller(file + "x").deserialize(read));
}
