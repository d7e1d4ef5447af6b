// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Reports of a deployer that is killed, as other programs read them: gnuplot, the module csv of Python, ncdump.
#include <support/child_process.hpp>
#include <support/temp_dir.hpp>

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

namespace {

using namespace oroforge::test;
using testing::HasSubstr;

class Readers : public testing::Test {
protected:
    /** Kills a deployer that reports each step of the component `grower`. */
    void reportAndKill(const std::string& type, const std::string& properties) {
        const auto simple = [](const std::string& name, const std::string& kind, const std::string& value) {
            return "<simple name='" + name + "' type='" + kind + "'><value>" + value + "</value></simple>";
        };
        directory_.write("app.xml", "<properties>" + simple("Import", "string", "reporttest") +
                                        "<struct name='grower' type='reporttest::Grower'/>"
                                        "<struct name='reporter' type='OCL::" +
                                        type + "'><struct name='Properties' type='PropertyBag'>" + properties +
                                        simple("Snapshot", "boolean", "1") +
                                        "<struct name='ReportData' type='PropertyBag'>" +
                                        simple("Component", "string", "grower") + "</struct></struct>" +
                                        simple("AutoConf", "boolean", "1") + simple("AutoStart", "boolean", "1") +
                                        "<struct name='Peers' type='PropertyBag'><simple type='string'><value>grower"
                                        "</value></simple></struct></struct></properties>");
        directory_.write("app.ops", "while true { grower.step()\nreporter.snapshot()\nyield }\n");
        Command command;
        command.program = DEPLOYER_PROGRAM;
        command.arguments = {"-s", "app.xml", "-s", "app.ops"};
        command.inputStaysOpen = true;
        command.directory = directory_.path();
        command.environment = {{"RTT_COMPONENT_PATH", OCL_TEST_PATH}, {"ORO_LOGFILE", "/dev/null"}};
        ChildProcess child(command);
        ASSERT_TRUE(child.waitForOutput("grown", std::chrono::seconds(30)));
        child.send(SIGKILL);
        const Outcome outcome = child.finish();
        ASSERT_EQ(128 + SIGKILL, outcome.status);
        ASSERT_THAT(outcome.err, testing::Not(HasSubstr("lost")));
    }
    std::string property(const std::string& name, const std::string& value) {
        return "<simple name='" + name + "' type='string'><value>" + value + "</value></simple>";
    }
    Outcome reader(const std::string& program, const std::vector<std::string>& arguments) {
        Command command;
        command.program = program;
        command.arguments = arguments;
        command.directory = directory_.path();
        return run(command);
    }
    bool has(const std::string& program) { return reader("which", {program}).status == 0; }

    TempDir directory_;
};

TEST_F(Readers, GnuplotReadsTheSameColumnFromTheFirstRowToTheLast) {
    if (!has("gnuplot")) GTEST_SKIP() << "gnuplot is not installed";
    reportAndKill("FileReporting", property("ReportFile", "r.dat"));
    // The last line may not be whole. Column 2 counts, column 3 is a text, 4 is twice as much; what grows is at the end.
    ASSERT_EQ(0, reader("sh", {"-c", "sed -i '$d' r.dat && head -n 1 r.dat > head"}).status);
    EXPECT_EQ(" TimeStamp grower.count grower.text grower.twice grower.levels[0]\n", readFile(directory_ / "head"));
    const Outcome outcome = reader(
        "gnuplot", {"-e",
                    "stats 'r.dat' using ($4 - 2 * $2) name 'A' nooutput; stats 'r.dat' using 2 name 'B' nooutput;"
                    "stats 'r.dat' using ($6 - $2) name 'C' nooutput;"
                    "print A_min, A_max, A_records == B_records, B_records > 300, C_min, C_max, C_records > 10"});
    EXPECT_EQ("0.0 0.0 1 1 0.0 0.0 1\n", outcome.err);
}

TEST_F(Readers, PythonReadsCsvWithAllDigitsAndTexts) {
    reportAndKill("FileReporting", property("ReportFile", "r.csv") + property("Format", "csv"));
    const Outcome outcome = reader(
        PYTHON, {"-c",
                 "import csv\nrows = list(csv.reader(open('r.csv', newline='')))[:-1]\nheader = None\nheads = n = 0\n"
                 "for row in rows:\n"
                 "    if row[0] == 'TimeStamp': header = row; heads += 1; continue\n"
                 "    assert len(row) == len(header), (row, header)\n"
                 "    r = dict(zip(header, row)); c = float(r['grower.count']); n += 1\n"
                 "    if c == 0: continue\n"
                 "    assert float(r['grower.twice']) == 2 * c, r\n"
                 "    assert r['grower.text'] == 'say \"%d\",\\nblank ' % c, r\n"
                 "    assert all(r['grower.levels.%d' % i] == '' or float(r['grower.levels.%d' % i]) == c + i / 3"
                 " for i in range(8) if 'grower.levels.%d' % i in r), r\n"
                 "assert header[:4] == ['TimeStamp', 'grower.count', 'grower.text', 'grower.twice'], header\n"
                 "print(n > 100, heads > 1)\n"});
    EXPECT_EQ("True True\n", outcome.out) << outcome.err;
}

TEST_F(Readers, NetcdfFilesHaveAllRowsUpToTheKill) {
    if (!WRITES_NETCDF) GTEST_SKIP() << "libnetcdf-dev was not installed";
    if (!has("ncdump")) GTEST_SKIP() << "ncdump is not installed";
    for (const char* decompose : {"0", "1"}) {
        reportAndKill("NetcdfReporting", property("ReportFile", "r.nc") +
                                             "<simple name='Decompose' type='boolean'><value>" + decompose +
                                             "</value></simple>");
        const Outcome dump = reader("ncdump", {"-v", "grower.count", "r.nc"});
        EXPECT_EQ(0, dump.status) << dump.err;
        EXPECT_THAT(dump.out, HasSubstr("double grower.count(time) ;"));
        if (reader(PYTHON, {"-c", "import netCDF4"}).status != 0) continue;
        const Outcome outcome =
            reader(PYTHON, {"-c",
                            "import netCDF4\nd = netCDF4.Dataset('r.nc'); v = d.variables\n"
                            "c = v['grower.count'][:]; t = netCDF4.chartostring(v['grower.text'][:])\n"
                            "s = v['grower.levels.size'][:]; n = len(c)\n"
                            "assert n > 100 and (v['grower.twice'][:] == 2 * c).all()\n"
                            "for r in range(1, n):\n"
                            "    if c[r] == 0: continue\n"
                            "    assert t[r] == 'say \"%d\",\\nblank ' % c[r], t[r]\n"
                            "    for i in range(s[r]):\n"
                            "        x = v['grower.levels'][r, i] if " +
                                std::string(*decompose == '0' ? "True" : "False") +
                                " else v['grower.levels.%d' % i][r]\n"
                                "        assert x == c[r] + i / 3, (r, i, x)\n"
                                "print('good', c[-1] > 100)\n"});
        EXPECT_EQ("good True\n", outcome.out) << outcome.err;
    }
}

/** Without the module, as where a Debian package is not installed. */
TEST_F(Readers, NetcdfReportsDoNotStartWithoutTheirModule) {
    if (!WRITES_NETCDF) GTEST_SKIP() << "libnetcdf-dev was not installed";
    const std::filesystem::path ocl = directory_ / "orocos/gnulinux/ocl";
    std::filesystem::create_directories(ocl);
    for (const auto& library : std::filesystem::directory_iterator(OCL_FOLDER))
        if (library.path().filename().string().find("-reporting") != std::string::npos)
            std::filesystem::copy(library.path(), ocl);
    directory_.write("app.ops",
                     "import(\"ocl\")\nloadComponent(\"r\", \"OCL::NetcdfReporting\")\naddPeer(\"r\", \"Deployer\")\n"
                     "r.reportData(\"Deployer\", \"AutoUnload\")\nr.configure()\nr.start()\n");
    Command command;
    command.program = DEPLOYER_PROGRAM;
    command.arguments = {"-s", "app.ops"};
    command.directory = directory_.path();
    command.environment = {{"RTT_COMPONENT_PATH", directory_ / "orocos"}, {"ORO_LOGFILE", "/dev/null"}};
    const Outcome outcome = run(command);
    EXPECT_THAT(outcome.err, HasSubstr("could not create 'reports.nc' for reporting: cannot load '" +
                                       (ocl / "netcdf/libocl-netcdf-writer-gnulinux.so").string() +
                                       "': cannot open shared object file: No such file or directory"));
    EXPECT_THAT(outcome.err, HasSubstr("libnetcdf19"));
    EXPECT_FALSE(std::filesystem::exists(directory_ / "reports.nc"));
}

}  // namespace
