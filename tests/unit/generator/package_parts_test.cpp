// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Kinds of packages, and what changes an existing one: --add, --upgrade, --check.
#include <gtest/gtest.h>
#include <support/child_process.hpp>
#include <support/golden.hpp>
#include <support/temp_dir.hpp>

namespace fs = std::filesystem;

namespace oroforge {
namespace {

class PackageParts : public testing::Test {
protected:
    test::Outcome run(std::vector<std::string> arguments, const std::string& folder = ".") {
        test::Command command;
        command.program = OROCREATE_PKG;
        command.arguments = std::move(arguments);
        command.directory = dir_.path() / folder;
        return test::run(command);
    }
    std::string read(const std::string& name) const { return test::readFile(dir_ / name); }
    bool has(const std::string& name) const { return fs::exists(dir_ / name); }

    /// Where `text` stands in the build file of package "pkg".
    std::size_t at(const std::string& text) const { return read("pkg/CMakeLists.txt").find(text); }

    test::TempDir dir_;
};

constexpr auto kNowhere = std::string::npos;

TEST_F(PackageParts, EachKindMakesItsSource) {
    for (const char* kind : {"component", "service", "plugin", "support", "application"}) {
        const std::string name = std::string("only_") + kind;
        EXPECT_EQ(run({name, kind}).status, 0);
        EXPECT_TRUE(has(name + "/src/" + name + "-" + kind + ".cpp")) << kind;
    }
    EXPECT_EQ(run({"types", "typekit"}).status, 0);
    EXPECT_TRUE(has("types/include/types/types-types.hpp"));
}

TEST_F(PackageParts, EmptyIsPackageXmlAlone) {
    EXPECT_EQ(run({"pkg", "empty"}).status, 0);
    EXPECT_EQ(test::readTree(dir_ / "pkg").size(), 1u);
    EXPECT_TRUE(has("pkg/package.xml"));
}

TEST_F(PackageParts, OptionsNameClassAndPeople) {
    ASSERT_EQ(run({"pkg", "component", "--class", "Pump", "--namespace", "plant::wet", "--license", "MIT", "--author",
                   "Ann <ann@example.org>", "--author", "Bob"})
                  .status,
              0);
    EXPECT_NE(read("pkg/src/pkg-component.hpp").find("class Pump : public"), kNowhere);
    EXPECT_NE(read("pkg/src/pkg-component.cpp").find("ORO_CREATE_COMPONENT(plant::wet::Pump)"), kNowhere);
    EXPECT_NE(read("pkg/deploy/pkg.xml").find("type=\"plant::wet::Pump\""), kNowhere);
    const std::string package = read("pkg/package.xml");
    EXPECT_NE(package.find("<license>MIT</license>"), kNowhere);
    EXPECT_NE(package.find("<author email=\"ann@example.org\">Ann</author>"), kNowhere);
    EXPECT_NE(package.find("<author>Bob</author>"), kNowhere);
    EXPECT_NE(package.find("<maintainer email=\"ann@example.org\">Ann</maintainer>"), kNowhere);
}

TEST_F(PackageParts, NamesThatCannotBeAreRefusedAndNothingIsWritten) {
    EXPECT_NE(run({"pkg", "--class", "a b"}).err.find("[OC008] class 'a b'"), kNowhere);
    EXPECT_NE(run({"pkg", "--namespace", "a:b"}).err.find("[OC008] namespace 'a:b'"), kNowhere);
    EXPECT_NE(run({"pkg", "--author", "<nobody>"}).err.find("[OC008] author '<nobody>'"), kNowhere);
    EXPECT_FALSE(has("pkg"));
}

TEST_F(PackageParts, CatkinByOptionAndByName) {
    fs::create_symlink(OROCREATE_PKG, dir_ / "orocreate-catkin-pkg");
    test::Command command;
    command.program = (dir_ / "orocreate-catkin-pkg").string();
    command.arguments = {"one"};
    command.directory = dir_.path();
    EXPECT_EQ(test::run(command).status, 0);
    EXPECT_EQ(run({"two", "--catkin"}).status, 0);
    for (const std::string name : {"one", "two"}) {
        EXPECT_NE(read(name + "/package.xml").find("<buildtool_depend>catkin</buildtool_depend>"), kNowhere) << name;
        EXPECT_FALSE(has(name + "/Makefile")) << name;
        EXPECT_NE(read(name + "/README.md").find("catkin_make -DPYTHON_EXECUTABLE=/usr/bin/python3"), kNowhere) << name;
    }
}

// As ROS reads it: catkin_pkg is the library behind catkin, rosdep and bloom.
TEST_F(PackageParts, ToolsOfRosAcceptThePackage) {
    ASSERT_EQ(run({"plain"}).status, 0);
    ASSERT_EQ(run({"my-pkg", "typekit", "--catkin", "--license", "MIT", "--author", "Ann <ann@example.org>"}).status,
              0);
    ASSERT_EQ(run({"bare", "empty"}).status, 0);
    for (const char* name : {"plain", "my-pkg", "bare"}) {
        test::Command command;
        command.program = "/usr/bin/python3";
        command.arguments = {"-c",
                             "import sys\n"
                             "from catkin_pkg.package import parse_package\n"
                             "warnings = []\n"
                             "package = parse_package(sys.argv[1], warnings=warnings)\n"
                             "package.validate(warnings=warnings)\n"
                             "print(package.name, warnings)\n",
                             (dir_ / name).string()};
        const test::Outcome outcome = test::run(command);
        EXPECT_EQ(outcome.out, std::string(name) + " []\n") << outcome.err;
    }
}

TEST_F(PackageParts, ADryRunOnlyTells) {
    const test::Outcome outcome = run({"pkg", "component", "--dry-run"});
    EXPECT_NE(outcome.out.find("would write pkg/src/pkg-component.cpp\n"), kNowhere);
    EXPECT_FALSE(has("pkg"));
}

TEST_F(PackageParts, ListTellsKindsAndTemplates) {
    const std::string out = run({"--list"}).out;
    EXPECT_NE(out.find("  application "), kNowhere);
    EXPECT_NE(out.find("  package/CMakeLists.txt\n"), kNowhere);
}

TEST_F(PackageParts, AddPutsTargetsBeforeTheLastStatement) {
    ASSERT_EQ(run({"pkg", "component"}).status, 0);
    const std::string before = read("pkg/CMakeLists.txt");
    for (const char* kind : {"component", "service", "plugin", "support", "application"}) {
        ASSERT_EQ(run({"--add", kind, "pump"}, "pkg").status, 0) << kind;
        EXPECT_TRUE(has(std::string("pkg/src/pump-") + kind + ".cpp"));
    }
    EXPECT_LT(at("orocos_component(pump "), at("orocos_generate_package()"));
    EXPECT_LT(at("orocos_service(pump-service "), at("orocos_generate_package()"));
    EXPECT_LT(at("add_executable(pump-test "), at("orocos_generate_package()"));
    // What was there stands as it was, in front of and behind the new lines.
    const std::string after = read("pkg/CMakeLists.txt");
    const std::size_t place = before.find("orocos_generate_package()");
    EXPECT_EQ(after.substr(0, place), before.substr(0, place));
    EXPECT_EQ(after.substr(after.size() - (before.size() - place)), before.substr(place));
}

TEST_F(PackageParts, AddedTypesJoinTheTypekit) {
    ASSERT_EQ(run({"pkg", "typekit"}).status, 0);
    ASSERT_EQ(run({"--add", "typekit", "pump"}, "pkg").status, 0);
    EXPECT_NE(at("orocos_typegen_headers(include/pkg/pkg-types.hpp include/pkg/pump-types.hpp)"), kNowhere);

    dir_.write("third/CMakeLists.txt",
               "project(third)\norocos_typegen_headers(-v a.hpp # the first )\n  b.hpp\n  DEPENDS "
               "other)\norocos_generate_package()\n");
    ASSERT_EQ(run({"--add", "typekit", "pump"}, "third").status, 0);
    EXPECT_NE(read("third/CMakeLists.txt").find("  b.hpp include/third/pump-types.hpp\n  DEPENDS other)"), kNowhere);

    ASSERT_EQ(run({"other", "component"}).status, 0);
    ASSERT_EQ(run({"--add", "typekit", "pump"}, "other").status, 0);
    EXPECT_NE(read("other/CMakeLists.txt").find("orocos_typegen_headers(include/other/pump-types.hpp)"), kNowhere);
}

TEST_F(PackageParts, AddRespectsWhatTheUserWrote) {
    dir_.write("pkg/CMakeLists.txt",
               "project( pkg )\r\n# orocos_generate_package() is not here\r\nmessage(\"orocos_generate_package()\")\r\n"
               "  OROCOS_GENERATE_PACKAGE(\r\n    INCLUDE_DIRS include)\r\n");
    ASSERT_EQ(run({"--add", "support", "pump"}, "pkg").status, 0);
    const std::string text = read("pkg/CMakeLists.txt");
    EXPECT_NE(text.find("orocos_generate_package()\")\r\n# Code that"), kNowhere) << text;
    EXPECT_NE(text.find("\r\n\r\n  OROCOS_GENERATE_PACKAGE("), kNowhere) << text;
    EXPECT_EQ(test::replaceAll(text, "\r\n", "").find('\n'), kNowhere);
}

TEST_F(PackageParts, AddWritesOverNothing) {
    ASSERT_EQ(run({"pkg", "component"}).status, 0);
    const auto before = test::readTree(dir_ / "pkg");
    EXPECT_NE(run({"--add", "component", "pkg"}, "pkg").err.find("[OC010]"), kNowhere);
    EXPECT_NE(run({"--add", "pumpp", "x"}, "pkg").err.find("[OC003]"), kNowhere);
    EXPECT_NE(run({"--add", "plugin", "1x"}, "pkg").err.find("[OC002]"), kNowhere);
    EXPECT_EQ(test::readTree(dir_ / "pkg"), before);
    EXPECT_NE(run({"--add", "component", "x"}).err.find("[OC009]"), kNowhere);

    dir_.write("computed/CMakeLists.txt", "project(${NAME})\norocos_generate_package()\n");
    EXPECT_NE(run({"--add", "support", "x"}, "computed").err.find("[OC009] the package is named '${NAME}'"), kNowhere);
    EXPECT_FALSE(has("computed/src"));

    dir_.write("odd/CMakeLists.txt", "project(odd)\n");
    const test::Outcome odd = run({"--add", "support", "x"}, "odd");
    EXPECT_NE(odd.err.find("[OC011]"), kNowhere);
    EXPECT_NE(odd.err.find("orocos_library(x-support src/x-support.cpp)"), kNowhere);
    EXPECT_FALSE(has("odd/src"));
}

TEST_F(PackageParts, UpgradeChangesDependenciesOnTheToolchain) {
    const std::string before = "<package>\n  <depend package=\"rtt\"/>\n  <depend  package='kdl' />\n</package>\n";
    dir_.write("ws/a/manifest.xml", before);
    EXPECT_EQ(run({"--upgrade", "ws", "--dry-run"}).out,
              "would write ws/a/manifest.xml\nwould write ws/a/manifest.xml.old\n");
    EXPECT_EQ(read("ws/a/manifest.xml"), before);

    EXPECT_EQ(run({"--upgrade", "ws"}).status, 0);
    EXPECT_EQ(read("ws/a/manifest.xml"),
              "<package>\n  <rosdep name=\"rtt\"/>\n  <depend  package='kdl' />\n</package>\n");
    EXPECT_EQ(read("ws/a/manifest.xml.old"), before);
    EXPECT_EQ(run({"--upgrade", "ws"}).out, "");
    EXPECT_NE(run({"--upgrade", "nowhere"}).err.find("[OC013]"), kNowhere);
}

TEST_F(PackageParts, CheckTellsStaleFiles) {
    dir_.write("tank.xml", "<package name=\"tank\"><component class=\"A\"/></package>\n");
    EXPECT_EQ(run({"--generate", "tank.xml", "--output", "o", "--check"}).status, 1);
    ASSERT_EQ(run({"--generate", "tank.xml", "--output", "o"}).status, 0);
    EXPECT_EQ(run({"--generate", "tank.xml", "--output", "o", "--check"}).status, 0);

    dir_.write("tank.xml",
               "<package name=\"tank\"><component class=\"A\"><operation name=\"f\"/></component></package>\n");
    const test::Outcome stale = run({"--generate", "tank.xml", "--output", "o", "--check"});
    EXPECT_EQ(stale.status, 1);
    EXPECT_EQ(
        stale.err.find("o/tank/ABase.cpp:6: error: [OC012] stale: orocreate-pkg now writes '    this->addOperation"),
        0U)
        << stale.err;
    EXPECT_NE(stale.err.find("o/tank/ABase.hpp:18: error: [OC012]"), kNowhere) << stale.err;
    EXPECT_EQ(stale.err.find("registration.cpp"), kNowhere);
}

}  // namespace
}  // namespace oroforge
