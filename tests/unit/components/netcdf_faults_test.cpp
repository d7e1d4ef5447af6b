// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What may go wrong with the files of NetcdfReporting.
#include "netcdf_fixture.hpp"

#include <reporting/netcdf_sink.hpp>
#include <reporting/record.hpp>

#include <chrono>
#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace {

using namespace components_test;
using namespace OCL::reporting;
using oroforge::test::readFile;

class NetcdfFaults : public NetcdfFiles {
protected:
    void start() {
        ASSERT_TRUE(files->reportPort("Machine", "speed"));
        ASSERT_TRUE(files->start());
    }
    /** Cycles until the writer has found the fault. */
    void cycleUntilError() {
        for (int i = 0; i != 400 && !files->inRunTimeError(); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
            next();
        }
        EXPECT_TRUE(files->inRunTimeError());
    }
};

TEST_F(NetcdfFaults, AFileThatCannotBeMadeFailsTheStart) {
    const LogText log;
    ASSERT_TRUE(files->reportPort("Machine", "speed"));
    for (const std::string& name :
         {std::string("/no/such/folder/x.nc"), std::string("/dev/full"), folder.path().string(), std::string("")}) {
        set(*files, "ReportFile", name);
        EXPECT_FALSE(files->start()) << name;
        EXPECT_THAT(log(), HasSubstr("could not create '" + name + "' for reporting: "));
    }
    EXPECT_THAT(log(), HasSubstr("'/no/such/folder/x.nc' for reporting: No such file or directory"));
    EXPECT_THAT(log(), HasSubstr("'/dev/full' for reporting: it is not an ordinary file"));
}

TEST_F(NetcdfFaults, AFileBelongsToOneReporter) {
    start();
    const LogText log;
    const auto other = make("Other");
    ASSERT_TRUE(other->reportPort("Machine", "speed"));
    EXPECT_FALSE(other->start());
    EXPECT_THAT(log(), HasSubstr("reports.nc' for reporting: another reporter is writing to it"));
    next();
    ASSERT_TRUE(files->stop());
    EXPECT_EQ("2\n", read("print(len(v['Machine.speed']))\n"));
    EXPECT_TRUE(other->start());
}

TEST_F(NetcdfFaults, ARemovedFileEndsTheReport) {
    const LogText log;
    start();
    std::filesystem::remove(folder / "reports.nc");
    cycleUntilError();
    ASSERT_TRUE(files->stop());
    const std::string said = log();
    const std::size_t first = said.find("reports.nc': somebody has removed it; no further rows are written");
    EXPECT_NE(std::string::npos, first) << said;
    EXPECT_EQ(std::string::npos, said.find("somebody", first + 20)) << said;
    EXPECT_LT(0u, lost());
    ASSERT_TRUE(files->start());  // makes it again
    ASSERT_TRUE(files->stop());
    EXPECT_EQ("1\n", read("print(len(v['Machine.speed']))\n"));
}

TEST_F(NetcdfFaults, AFileThatTookItsPlaceIsNotTouched) {
    const LogText log;
    start();
    std::filesystem::rename(folder / "reports.nc", folder / "before.nc");
    folder.write("reports.nc", "precious");
    cycleUntilError();
    ASSERT_TRUE(files->stop());
    EXPECT_THAT(log(), HasSubstr("somebody has put another file in its place"));
    EXPECT_EQ("precious", readFile(folder / "reports.nc"));
    EXPECT_NE("0\n", read("print(len(v['Machine.speed']))\n", "before.nc"));
}

TEST_F(NetcdfFaults, AFullDiskEndsTheReportAtAWholeRow) {
    const LogText log;
    start();
    // What setrlimit() does is as good as a full disk; the writing thread takes no signal.
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small{200000, before.rlim_max};
    std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    for (int i = 0; i < 10000; ++i) next();
    cycleUntilError();
    ASSERT_TRUE(files->stop());
    setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_THAT(log(), HasSubstr("File too large; no further rows are written"));
    const std::string rows = read("print(len(v['Machine.speed']), v['TimeStamp'][-1] > 100)\n");
    EXPECT_THAT(rows, HasSubstr(" True"));
    EXPECT_GT(std::filesystem::file_size(folder / "reports.nc"), 100000u);
    EXPECT_LT(0u, lost());
}

TEST_F(NetcdfFaults, NoRoomForTheHeadIsAnErrorToo) {
    const LogText log;
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small{100, before.rlim_max};
    std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    start();
    cycleUntilError();
    ASSERT_TRUE(files->stop());
    setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_THAT(log(), HasSubstr("File too large; no further rows are written"));
    EXPECT_LT(0u, lost());
}

/** Rows of one sequence, with the private parts. */
class NetcdfGoesOn : public NetcdfFaults {
protected:
    void row(RowSink& sink, std::uint32_t size, bool first = false) {
        Record record;
        record.value(Tag::Sequence, size);
        for (std::uint32_t i = 0; i != size; ++i) record.value(Tag::Real, static_cast<double>(size));
        if (!first) return sink.row(record.data(), record.size());
        Field report;
        Field sequence;
        sequence.name = "s";
        sequence.kind = Field::Kind::Sequence;
        sequence.mayGrow = true;
        sequence.parts.emplace_back();
        sequence.parts.front().type.number = Number::Real;
        report.kind = Field::Kind::Group;
        report.parts.push_back(sequence);
        sink.fields(report, record.data(), record.size());
    }
};

TEST_F(NetcdfGoesOn, ALargeFileStaysAndTheReportGoesOnInAnother) {
    const LogText log;
    std::string error;
    const auto sink = netcdfSink(NetcdfFile::open(folder / "reports.nc", error), 0);
    ASSERT_EQ("", error);
    RowOptions options;
    options.decompose = false;
    sink->prepare(options);
    row(*sink, 1, true);
    for (const std::uint32_t size : {1U, 1U, 2U, 3U, 4U, 5U, 1U}) row(*sink, size);
    EXPECT_EQ("", sink->write());
    const std::string script =
        "print(v['s.size'][:].tolist(), d.dimensions['s_dim'].size, d.continued_in, getattr(d, 'continues', '-'))\n";
    EXPECT_EQ("[1, 1] 1 reports.2.nc -\n", read(script));
    EXPECT_EQ("[2] 2 reports.3.nc reports.nc\n", read(script, "reports.2.nc"));
    EXPECT_EQ("[3, 4] 4 reports.4.nc reports.2.nc\n", read(script, "reports.3.nc"));
    EXPECT_EQ("[5, 1] 8  reports.3.nc\n", read(script, "reports.4.nc"));
    EXPECT_THAT(log(), HasSubstr("goes on in file '"));
}

TEST_F(NetcdfGoesOn, AFolderThatTakesNoOtherFileEndsTheReport) {
    std::string error;
    const auto sink = netcdfSink(NetcdfFile::open(folder / "reports.nc", error));
    sink->prepare(RowOptions());
    row(*sink, 1, true);
    row(*sink, 1);
    EXPECT_EQ("", sink->write());
    std::filesystem::create_directory(folder / "reports.nc.new");
    row(*sink, 1);
    row(*sink, 2);
    row(*sink, 1);
    EXPECT_THAT(sink->write(), HasSubstr("reports.nc.new', which gives its variables more room: Is a directory"));
    EXPECT_EQ(2u, sink->rows());
    EXPECT_EQ("[1, 1]\n", read("print(v['s.size'][:].tolist())\n"));
}

}  // namespace
