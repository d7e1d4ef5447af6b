// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Configurations that are generated from .cfg files: the one of dynamic_reconfigure's own tests.
#include "reconfigure_fixture.hpp"

#include <dynamic_reconfigure/TestConfig.h>

#include <gtest/gtest.h>

namespace {
/** The same configuration with an Updater of its own. */
template <int Number>
struct ConfigLikeTest : dynamic_reconfigure_test::TestConfig {
    ConfigLikeTest() = default;
    ConfigLikeTest(const dynamic_reconfigure_test::TestConfig& other) : TestConfig(other) {}
    static ConfigLikeTest __getMin__() { return TestConfig::__getMin__(); }
    static ConfigLikeTest __getMax__() { return TestConfig::__getMax__(); }
    static ConfigLikeTest __getDefault__() { return TestConfig::__getDefault__(); }
};
typedef ConfigLikeTest<1> OwnConfig;
typedef ConfigLikeTest<2> MemberConfig;
}  // namespace

namespace rtt_dynamic_reconfigure {
template <>
struct Updater<OwnConfig> {
    static bool propertiesFromConfig(OwnConfig& config, std::uint32_t, RTT::PropertyBag& bag) {
        return setProperty<float>("power", bag, config.double_) && setProperty<int>("size", bag, config.int_);
    }
    static bool configFromProperties(OwnConfig& config, const RTT::PropertyBag& bag) {
        return getProperty<float>("power", bag, config.double_) && getProperty<int>("size", bag, config.int_);
    }
};

/** As some packages have it: members that are not static. */
template <>
struct Updater<MemberConfig> {
    virtual ~Updater() = default;
    virtual bool propertiesFromConfig(MemberConfig& config, std::uint32_t, RTT::PropertyBag& bag) {
        return setProperty<int>("size", bag, config.int_);
    }
    virtual bool configFromProperties(MemberConfig& config, const RTT::PropertyBag& bag) {
        return getProperty<int>("size", bag, config.int_);
    }
};
}  // namespace rtt_dynamic_reconfigure

namespace {

using namespace reconfigure_test;
using dynamic_reconfigure_test::TestConfig;

TEST(RosGeneratedConfig, PropertiesHaveTheNamesOfParameters) {
    const Node node;
    RTT::TaskContext component("c");
    double value = 1;
    int whole = 2;
    std::string text = "t";
    component.addProperty("double_", value);
    component.addProperty("int_", whole);
    component.addProperty("str_", text);
    component.addOperation("updateProperties", [&](const RTT::PropertyBag& bag, unsigned) {
        return RTT::refreshProperties(*component.properties(), bag);
    });
    unsigned level = 0;
    component.addOperation("notifyPropertiesUpdate", [&](unsigned now) { level = now; });
    const boost::shared_ptr<Server<TestConfig>> server(new Server<TestConfig>(&component));
    ASSERT_TRUE(component.provides()->addService(server));
    ASSERT_TRUE(server->advertise());
    ASSERT_TRUE(component.start());
    const ConfigDescription description = descriptionOf("/tester/c");
    EXPECT_EQ(std::to_string(TestConfig::__getMax__().int_), in(description.max, "int_"));
    EXPECT_GT(description.groups.size(), 3u);
    EXPECT_EQ("2", in(updateOf("/tester/c"), "int_"));
    Config got;
    ASSERT_TRUE(set("/tester/c", a("int_", 100000) + a("str_", "new") + a("deep_var_int", 1), &got));
    EXPECT_EQ(TestConfig::__getMax__().int_, whole);
    EXPECT_EQ("new", text);
    EXPECT_EQ("1", in(got, "deep_var_int")) << "a parameter without a property stays";
    const TestConfig before = TestConfig::__getDefault__();
    TestConfig after = before;
    after.int_ += 1;
    after.str_ += "x";
    after.deep_var_int += 1;
    EXPECT_EQ(before.__level__(after), level);
    EXPECT_TRUE(server->updated());
    EXPECT_EQ("1", in(updateOf("/tester/c"), "deep_var_int"));
    component.stop();
}

TEST(RosGeneratedConfig, ASpecialisedUpdaterHasItsOwnProperties) {
    const Node node;
    RTT::TaskContext component("c");
    float power = 1;
    int size = 2;
    component.addProperty("power", power);
    component.addProperty("size", size);
    const boost::shared_ptr<Server<OwnConfig>> server(new Server<OwnConfig>("own", &component));
    ASSERT_TRUE(component.provides()->addService(server));
    RTT::Property<RTT::PropertyBag> max = server->properties()->getProperty("max");
    ASSERT_NE(nullptr, max.rvalue().getPropertyType<int>("size"));
    EXPECT_EQ(TestConfig::__getMax__().int_, max.rvalue().getPropertyType<int>("size")->get());
    max.rvalue().getPropertyType<int>("size")->set(7);
    ASSERT_TRUE(server->advertise("/c"));
    EXPECT_EQ("7", in(descriptionOf("/c").max, "int_"));
    ASSERT_TRUE(set("/c", a("int_", 9) + a("double_", 0.5)));
    EXPECT_EQ(7, size);
    EXPECT_EQ(0.5f, power);
}

TEST(RosGeneratedConfig, ASpecialisedUpdaterNeedNotBeStatic) {
    const Node node;
    RTT::TaskContext component("c");
    int size = 2;
    component.addProperty("size", size);
    const boost::shared_ptr<Server<MemberConfig>> server(new Server<MemberConfig>("own", &component));
    ASSERT_TRUE(component.provides()->addService(server));
    ASSERT_TRUE(server->advertise("/c"));
    ASSERT_TRUE(set("/c", a("int_", 9)));
    EXPECT_EQ(9, size);
}

TEST(RosGeneratedConfig, PropertiesAreSetAndGotByType) {
    using namespace rtt_dynamic_reconfigure;
    RTT::PropertyBag bag;
    EXPECT_TRUE(setProperty<double>("x", bag, 1.5f));
    EXPECT_TRUE(setProperty<double>("x", bag, 2));
    EXPECT_FALSE(setProperty<int>("x", bag, 3));
    float value = 0;
    EXPECT_TRUE(getProperty<double>("x", bag, value));
    EXPECT_EQ(2, value);
    EXPECT_FALSE(getProperty<double>("y", bag, value));
    EXPECT_FALSE(getProperty<bool>("x", bag, value));
    EXPECT_EQ(2, value);
}

}  // namespace
