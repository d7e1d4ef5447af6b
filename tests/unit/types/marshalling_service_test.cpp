// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The service "marshalling" in a component (spec 6.4).
#include "builtin_typekit.hpp"

#include <rtt/OperationCaller.hpp>
#include <rtt/Property.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/marsh/Marshalling.hpp>
#include <rtt/marsh/MarshallingService.hpp>

#include <filesystem>
#include <fstream>
#include <unistd.h>

using namespace RTT;
using namespace types_test;

namespace {

class MarshallingOfAComponent : public WithBuiltinTypes {
protected:
    void SetUp() override {
        file = (std::filesystem::temp_directory_path() / ("marshalling_" + std::to_string(getpid()) + ".cpf")).string();
        std::filesystem::remove(file);
        component.addProperty("gain", gain);
        component.provides("inner")->addProperty("depth", depth);
        ASSERT_TRUE(component.provides()->addService(Service::shared_ptr(new marsh::MarshallingService(&component))));
    }
    void TearDown() override { std::filesystem::remove(file); }

    bool call(const std::string& operation) {
        OperationCaller<bool(const std::string&)> caller(component.provides("marshalling")->getOperation(operation));
        EXPECT_TRUE(caller.ready()) << operation;
        return caller.ready() && caller(file);
    }
    bool call(const std::string& operation, const std::string& a, const std::string& b) {
        OperationCaller<bool(const std::string&, const std::string&)> caller(
            component.provides("marshalling")->getOperation(operation));
        EXPECT_TRUE(caller.ready()) << operation;
        return caller.ready() && caller(a, b);
    }

    TaskContext component{"component"};
    double gain = 1.5;
    int depth = 3;
    std::string file;
};

}  // namespace

TEST_F(MarshallingOfAComponent, WhatIsStoredIsRead) {
    ASSERT_TRUE(call("storeProperties"));
    for (const char* operation : {"readProperties", "updateProperties", "loadProperties"}) {
        gain = 0;
        EXPECT_TRUE(call(operation)) << operation;
        EXPECT_EQ(1.5, gain) << operation;
    }
}

TEST_F(MarshallingOfAComponent, ReadNeedsAllUpdateDoesNot) {
    std::ofstream(file) << "<properties/>";
    EXPECT_FALSE(call("readProperties"));
    EXPECT_TRUE(call("updateProperties"));
}

TEST_F(MarshallingOfAComponent, LoadCreatesProperties) {
    std::ofstream(file) << "<properties><simple name=\"new\" type=\"long\"><value>4</value></simple></properties>";
    ASSERT_TRUE(call("loadProperties"));
    ASSERT_NE(nullptr, component.properties()->getPropertyType<int>("new"));
    EXPECT_EQ(4, component.properties()->getPropertyType<int>("new")->get());
}

TEST_F(MarshallingOfAComponent, SingleProperties) {
    EXPECT_TRUE(call("writeProperty", "gain", file));
    gain = 0;
    EXPECT_TRUE(call("readProperty", "gain", file));
    EXPECT_EQ(1.5, gain);
    EXPECT_FALSE(call("readProperty", "nothing", file));
    EXPECT_FALSE(call("writeProperty", "nothing", file));
}

TEST_F(MarshallingOfAComponent, ServicesHaveFilesOfTheirOwn) {
    ASSERT_TRUE(call("storeServiceProperties", file, "inner"));
    depth = 0;
    EXPECT_TRUE(call("readServiceProperties", file, "inner"));
    EXPECT_EQ(3, depth);
    EXPECT_FALSE(call("readServiceProperties", file, "no_such_service"));
    EXPECT_FALSE(call("readProperties")) << "the file has only the properties of the service";
}

TEST_F(MarshallingOfAComponent, RequesterCallsTheService) {
    Marshalling marshalling;
    ASSERT_TRUE(marshalling.connectTo(component.provides("marshalling")));
    ASSERT_TRUE(marshalling.writeProperties(file));
    gain = 7;
    EXPECT_TRUE(marshalling.updateFile(file));
    gain = 0;
    EXPECT_TRUE(marshalling.readProperties(file));
    EXPECT_EQ(7, gain);
    ASSERT_TRUE(marshalling.storeServiceProperties(file, "inner"));
    depth = 0;
    EXPECT_TRUE(marshalling.readServiceProperty("depth", file, "inner"));
    EXPECT_EQ(3, depth);
}

TEST_F(MarshallingOfAComponent, EveryServiceOperationWorksOnTheService) {
    for (const char* operation : {"storeServiceProperties", "writeServiceProperties", "updateServiceFile",
                                  "loadServiceProperties", "readServiceProperties", "updateServiceProperties"}) {
        EXPECT_TRUE(call(operation, file, "inner")) << operation;
        EXPECT_FALSE(call(operation, file, "no_such_service")) << operation;
    }
    OperationCaller<bool(const std::string&, const std::string&, const std::string&)> one(
        component.provides("marshalling")->getOperation("writeServiceProperty"));
    depth = 8;
    EXPECT_TRUE(one("depth", file, "inner"));
    depth = 0;
    EXPECT_TRUE(call("updateServiceProperties", file, "inner"));
    EXPECT_EQ(8, depth);
    EXPECT_FALSE(one("gain", file, "inner"));
}

TEST_F(MarshallingOfAComponent, FailedLoadsChangeNothing) {
    std::ofstream(file) << "<properties><simple name=\"new\" type=\"long\"><value>4</value></simple>"
                           "<simple name=\"gain\" type=\"string\"><value>x</value></simple></properties>";
    for (const char* operation : {"readProperties", "updateProperties", "loadProperties"}) {
        EXPECT_FALSE(call(operation)) << operation;
        EXPECT_EQ(1.5, gain);
        EXPECT_EQ(nullptr, component.properties()->find("new"));
    }
    EXPECT_FALSE(call("readProperty", "gain", file));
}
