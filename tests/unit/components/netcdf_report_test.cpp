// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What is in NetCDF files, as python3-netcdf4 reads it.
#include "netcdf_fixture.hpp"

#include <limits>

namespace {

using namespace components_test;

class NetcdfReport : public NetcdfFiles {};

/** A property of each type of numbers. */
class Numbers : public RTT::TaskContext {
public:
    Numbers() : RTT::TaskContext("Numbers") {
        add<bool>("bool", true);
        add<char>("char", 'c');
        add<signed char>("int8", -128);
        add<unsigned char>("uint8", 255);
        add<short>("short", -32768);
        add<unsigned short>("ushort", 65535);
        add<int>("int", std::numeric_limits<int>::min());
        add<unsigned>("uint", std::numeric_limits<unsigned>::max());
        add<long long>("llong", std::numeric_limits<long long>::min());
        add<unsigned long long>("ullong", std::numeric_limits<unsigned long long>::max());
        add<float>("float", 0.1f);
        add<double>("double", 0.1);
        add<std::string>("string", "two words");
    }
    std::vector<std::string> known;

private:
    template <class T>
    void add(const std::string& name, T value) {
        if (!RTT::internal::DataSourceTypeInfo<T>::getTypeInfo()->buildValue()) return;
        addProperty(name, *new RTT::Property<T>(name, "The " + name + ". [unit]", value));
        known.push_back(name);
    }
    template <class T>
    void addProperty(const std::string&, RTT::Property<T>& property) {
        properties()->ownProperty(&property);
    }
};

TEST_F(NetcdfReport, EachTypeOfNumberHasItsOwn) {
    Numbers numbers;
    files->addPeer(&numbers);
    for (const std::string& name : numbers.known) ASSERT_TRUE(files->reportData("Numbers", name));
    ASSERT_TRUE(files->start());
    ASSERT_TRUE(files->stop());
    const std::string told = read(
        "d.set_auto_mask(False)\n"
        "for n, x in v.items():\n"
        "    x = v[n]; print(n, x.dtype, text(x)[0] if x.dtype == 'S1' else repr(x[0].item()), getattr(x, 'units', "
        "'-'))\n");
    EXPECT_THAT(told, HasSubstr("TimeStamp float64 0.0 s\n"));
    EXPECT_THAT(told, HasSubstr("Numbers.bool int8 1 unit\n"));
    EXPECT_THAT(told, HasSubstr("Numbers.char int8 99 unit\n"));
    EXPECT_THAT(told, HasSubstr("Numbers.int int32 -2147483648 unit\n"));
    EXPECT_THAT(told, HasSubstr("Numbers.uint uint32 4294967295 unit\n"));
    EXPECT_THAT(told, HasSubstr("Numbers.float float32 0.10000000149011612 unit\n"));
    EXPECT_THAT(told, HasSubstr("Numbers.double float64 0.1 unit\n"));
    EXPECT_THAT(told, HasSubstr("Numbers.string |S1 two words -\n"));
    const std::map<std::string, std::string> others = {{"int8", "int8 -128"},
                                                       {"uint8", "uint8 255"},
                                                       {"short", "int16 -32768"},
                                                       {"ushort", "uint16 65535"},
                                                       {"llong", "int64 -9223372036854775808"},
                                                       {"ullong", "uint64 18446744073709551615"}};
    for (const std::string& name : numbers.known) {
        const auto other = others.find(name);
        if (other == others.end()) continue;
        EXPECT_THAT(told, HasSubstr("Numbers." + name + " " + other->second + " unit\n"));
    }
}

sample::Tank someTank() {
    sample::Tank tank;
    tank.id = -7;
    tank.label = "left";
    tank.position = {1, 2};
    tank.levels = {0.5, 0.25};
    tank.path = {{3, 4}};
    tank.weights[2] = 9;
    tank.pair = {{5, 6}};
    tank.mode = sample::Mode::Draining;
    tank.small = 200;
    tank.flags = {true, false};
    return tank;
}

TEST_F(NetcdfReport, PartsOfStructsHaveVariablesWithUnitsAndDescriptions) {
    machine.tank.doc("The tank on the left.");
    machine.tank.write(someTank());
    ASSERT_TRUE(files->reportPort("Machine", "tank"));
    ASSERT_TRUE(files->start());
    ASSERT_TRUE(files->stop());
    EXPECT_EQ(
        "id [-7] The tank on the left.\n"
        "label ['left'] The tank on the left.\n"
        "position.x [1.0] east\n"
        "position.y [2.0] north\n"
        "levels.size [2] The number of elements of Machine.tank.levels.\n"
        "levels.0 [0.5] The tank on the left.\n"
        "levels.1 [0.25] The tank on the left.\n"
        "path.size [1] The number of elements of Machine.tank.path.\n"
        "path.0.x [3.0] east\n"
        "path.0.y [4.0] north\n"
        "weights.0 [0.0] The tank on the left.\n"
        "weights.1 [0.0] The tank on the left.\n"
        "weights.2 [9.0] The tank on the left.\n"
        "pair.0 [5] The tank on the left.\n"
        "pair.1 [6] The tank on the left.\n"
        "mode [7] The tank on the left.\n"
        "small [200] The tank on the left.\n"
        "flags.size [2] The number of elements of Machine.tank.flags.\n"
        "flags.0 [1] The tank on the left.\n"
        "flags.1 [0] The tank on the left.\n"
        "m [0 1 7] Idle Filling Draining True\n",
        read("for n, x in v.items():\n"
             "    if n != 'TimeStamp': print(n[13:], text(x) if x.dtype == 'S1' else x[:].tolist(), x.long_name)\n"
             "m = v['Machine.tank.mode']\n"
             "print(v['Machine.tank.position.x'].units, m.flag_values, m.flag_meanings, "
             "d.dimensions['time'].isunlimited())\n"));
}

TEST_F(NetcdfReport, WithoutDecomposeASequenceOfNumbersIsOneVariable) {
    set(*files, "Decompose", false);
    machine.levels.setDataSample({0, 0});
    machine.tank.write(someTank());
    for (const char* port : {"levels", "tank"}) ASSERT_TRUE(files->reportPort("Machine", port));
    ASSERT_TRUE(files->start());
    for (const std::vector<double>& levels : {std::vector<double>{1}, {}, {2, 3, 4}, {5}}) {
        machine.levels.write(levels);
        next();
    }
    ASSERT_TRUE(files->stop());
    EXPECT_EQ(
        "[2, 1, 0, 3, 1] ('time', 'Machine.levels_dim')\n"
        "[[0.0, 0.0, None, None], [1.0, None, None, None], [None, None, None, None], [2.0, 3.0, 4.0, None], "
        "[5.0, None, None, None]]\n"
        "[0.0, 0.5, 1.0, 1.5, 2.0] [7, 7, 7, 7, 7] [0.0, 0.0, 9.0]\n",
        read(
            "x = v['Machine.levels']\nprint(v['Machine.levels.size'][:].tolist(), x.dimensions)\nprint(x[:].tolist())\n"
            "print(v['TimeStamp'][:].tolist(), v['Machine.tank.mode'][:].tolist(), "
            "v['Machine.tank.weights'][0].tolist())\n"));
    EXPECT_EQ(0u, lost());
}

TEST_F(NetcdfReport, WhatGrowsKeepsTheRowsBefore) {
    machine.limits.ownProperty(new RTT::Property<int>("low", "", 1));
    for (const char* name : {"label", "limits"}) ASSERT_TRUE(files->reportData("Machine", name));
    for (const char* port : {"levels", "tank"}) ASSERT_TRUE(files->reportPort("Machine", port));
    ASSERT_TRUE(files->start());
    next();
    machine.levels.write({1, 2});
    next();
    machine.label = std::string(1000, 'x');
    next();
    machine.limits.ownProperty(new RTT::Property<std::string>("high", "", "much"));
    machine.levels.write({3});
    machine.tank.write(someTank());
    next();
    ASSERT_TRUE(files->stop());
    EXPECT_EQ(
        "[0, 0, 2, 2, 1] [None, None, 1.0, 1.0, 3.0] [None, None, 2.0, 2.0, None]\n"
        "[4, 4, 4, 1000, 1000] [1, 1, 1, 1, 1] ['', '', '', '', 'much'] [None, None, None, None, 3.0]\n",
        read("print(v['Machine.levels.size'][:].tolist(), v['Machine.levels.0'][:].tolist(), "
             "v['Machine.levels.1'][:].tolist())\n"
             "print([len(s) for s in text(v['Machine.label'])], v['Machine.limits.low'][:].tolist(), "
             "text(v['Machine.limits.high']), v['Machine.tank.path.0.x'][:].tolist())\n"));
    EXPECT_EQ(0u, lost());
    EXPECT_FALSE(std::filesystem::exists(folder / "reports.nc.new"));
}

TEST_F(NetcdfReport, WhatIsLeftOutIsMissing) {
    set(*files, "ReportOnlyNewData", true);
    machine.mode.write(sample::Mode::Filling);
    machine.speed.write(1);
    for (const char* port : {"speed", "mode"}) ASSERT_TRUE(files->reportPort("Machine", port));
    ASSERT_TRUE(files->reportData("Machine", "gain"));
    ASSERT_TRUE(files->start());
    machine.speed.write(2);
    next();
    machine.mode.write(sample::Mode::Idle);
    machine.gain = 3;
    next();
    ASSERT_TRUE(files->stop());
    EXPECT_EQ("[1.0, 2.0, None] [1, None, 0] [1.5, None, 3.0]\n",
              read("print(*(v['Machine.' + n][:].tolist() for n in ('speed', 'mode', 'gain')))\n"));
}

TEST_F(NetcdfReport, NamesThatNetcdfForbidsBecomeOthersAndAreReported) {
    const LogText log;
    const std::string longName(400, 'n');
    for (const std::string& name :
         {std::string("a/b"), std::string("a_b"), std::string("ä b"), longName, longName + "2"})
        machine.limits.ownProperty(new RTT::Property<int>(name, "", 1));
    machine.limits.ownProperty(new RTT::Property<int>("twice", "", 2));
    RTT::Property<int> twice("twice", "", 3);
    machine.limits.add(&twice);
    RTT::TaskContext strange("-odd name ");
    RTT::OutputPort<double> port("port/ ");
    strange.ports()->addPort(port);
    files->addPeer(&strange);
    ASSERT_TRUE(files->reportComponent("-odd name "));
    ASSERT_TRUE(files->reportData("Machine", "limits"));
    ASSERT_TRUE(files->start());
    ASSERT_TRUE(files->stop());
    EXPECT_EQ(
        "TimeStamp\n_-odd_name_.port__ = -odd name .port/ \nMachine.limits.a_b = Machine.limits.a/b\n"
        "Machine.limits.a_b_2 = Machine.limits.a_b\nMachine.limits.___b = Machine.limits.\xc3\xa4 b\n"
        "Machine.limits.+n... 230\nMachine.limits.+n... 232\nMachine.limits.twice\n"
        "Machine.limits.twice_2 = Machine.limits.twice\n",
        read("import re\nfor n, x in v.items():\n"
             "    if 'nnnn' in n: print(re.sub('n.*', '+n...', n[15:]).join([n[:15], '']), len(n))\n"
             "    else: print(n + (' = ' + x.reported_as if hasattr(x, 'reported_as') else ''))\n"));
    EXPECT_THAT(log(), HasSubstr("variables of the report of 'Files' have other names"));
}

TEST_F(NetcdfReport, ThousandsOfVariables) {
    RTT::TaskContext many("Many");
    std::vector<std::unique_ptr<RTT::OutputPort<double>>> ports;
    for (int i = 0; i < 1500; ++i) {
        ports.push_back(std::make_unique<RTT::OutputPort<double>>("p" + std::to_string(i)));
        many.ports()->addPort(*ports.back());
        ports.back()->write(i);
    }
    files->addPeer(&many);
    ASSERT_TRUE(files->reportComponent("Many"));
    ASSERT_TRUE(files->start());
    next();
    ASSERT_TRUE(files->stop());
    EXPECT_EQ("1501 [1499.0, 1499.0]\n", read("print(len(v), v['Many.p1499'][:].tolist())\n"));
}

}  // namespace
