// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Recordings as tables and as NetCDF files, which ncdump and netCDF4 read.
#include "mcap_tool_fixture.hpp"

#include <filesystem>

namespace {

using namespace mcap_test;
using testing::HasSubstr;

TEST_F(Tool, ConvertsATopicToCsv) {
    record("run.mcap", messages());
    const std::string table =
        "time,height,name,side,path[0].x,path[0].y,valves[0],valves[1],path[1].x,path[1].y\n"
        "1.500000000,1.5,\"a \"\"quoted\"\", text\n\",-1,0,0.5,true,false,,\n"
        "2.500000000,2.25,b,-1,0,0.5,true,false,1,0.5\n";
    EXPECT_EQ(table, expect(0, {"convert", "run.mcap", "--topic", "/tank/level"}).out);
    expect(0, {"convert", "run.mcap", "--topic", "/tank/level", "-o", "level.csv"});
    EXPECT_EQ(table, readText("level.csv"));
    EXPECT_THAT(expect(2, {"convert", "run.mcap", "--topic", "/tank/level", "-o", "level.csv"}).err,
                HasSubstr("level.csv: error: the file exists"));
    EXPECT_THAT(expect(2, {"convert", "run.mcap"}).err, HasSubstr("name it with --topic: /tank/count /tank/level"));
    EXPECT_THAT(expect(2, {"convert", "run.mcap", "--to", "xls"}).err,
                HasSubstr("--to: found 'xls', expected csv, table or netcdf"));
}

TEST_F(Tool, ConvertsAllTopicsToATableAsFileReportingWritesIt) {
    record("run.mcap", messages());
    const std::string table =
        " TimeStamp tank.level.height tank.level.name tank.level.side tank.level.path.0.x tank.level.path.0.y "
        "tank.level.valves.0 tank.level.valves.1 tank.count tank.level.path.1.x tank.level.path.1.y\n"
        " 0 1.5 a\\x20\\x22quoted\\x22,\\x20text\\n -1 0 0.5 1 0 nan nan nan \n"
        " 0.5 1.5 a\\x20\\x22quoted\\x22,\\x20text\\n -1 0 0.5 1 0 -7 nan nan \n"
        " 1 2.25 b -1 0 0.5 1 0 -7 1 0.5 \n"
        " 1.5 2.25 b -1 0 0.5 1 0 9 1 0.5 \n";
    EXPECT_EQ(table, expect(0, {"convert", "run.mcap", "--to", "table"}).out);
    expect(0, {"convert", "run.mcap", "-o", "run.dat"});
    EXPECT_EQ(table, readText("run.dat"));
    EXPECT_EQ(" TimeStamp tank.count\n 0 -7 \n 1 9 \n",
              expect(0, {"convert", "run.mcap", "--to", "table", "--topic", "/tank/count"}).out);
    std::vector<Told> same = messages();
    std::get<2>(same[1]) = std::get<2>(same[0]);
    std::get<3>(same[2]) = level(2.25, "", 0);
    record("same.mcap", same);
    EXPECT_THAT(
        expect(0, {"convert", "same.mcap", "--to", "table"}).out,
        HasSubstr("\n 0 1.5 a\\x20\\x22quoted\\x22,\\x20text\\n -1 0 0.5 1 0 -7 \n 1 2.25 \"\" -1 nan nan 1 0 -7 \n"));
    EXPECT_THAT(expect(2, {"convert", "run.mcap", "--to", "table", "--topic", "/tank/cont"}).err,
                HasSubstr("did you mean"));
}

TEST_F(Tool, ConvertsAllTopicsToNetcdf) {
    record("run.mcap", messages());
    EXPECT_THAT(expect(2, {"convert", "run.mcap", "--to", "netcdf"}).err, HasSubstr("a NetCDF file is not printed"));
    expect(0, {"convert", "run.mcap", "-o", "run.nc"});
    EXPECT_THAT(expect(2, {"convert", "run.mcap", "-o", "run.nc"}).err, HasSubstr("run.nc: error: the file exists"));
    const auto read = [&](const std::string& program, const std::vector<std::string>& words) {
        Command command;
        command.program = program;
        command.arguments = words;
        command.directory = directory.path();
        const Outcome outcome = oroforge::test::run(command);
        EXPECT_EQ(0, outcome.status) << outcome.err;
        return outcome.out;
    };
    if (std::filesystem::exists("/usr/bin/ncdump")) {
        const std::string text = read("/usr/bin/ncdump", {"run.nc"});
        for (const char* const part :
             {"tank.level.time = 2 ;", "tank.count.time = 2 ;", "int64 tank.level.time(tank.level.time) ;",
              "tank.level.time:units = \"nanoseconds\" ;", "double tank.level.height(tank.level.time) ;",
              "char tank.level.name(tank.level.time, tank.level.name_len) ;", "byte tank.level.side(tank.level.time) ;",
              "byte tank.level.valves(tank.level.time, tank.level.valves_dim) ;", "int tank.count(tank.count.time) ;",
              "ushort tank.level.path\\[1\\].x(tank.level.time) ;", "tank.level.path\\[1\\].x:_FillValue = 65535US ;",
              " tank.level.height = 1.5, 2.25 ;", " tank.count = -7, 9 ;", "\n  \"b\" ;",
              " tank.level.path\\[1\\].x = _, 1 ;", "tank.level.path\\[1\\].y = _, 0.5 ;", "  1, 0,\n  1, 0 ;",
              " tank.count.time = 2000000000, 3000000000 ;"})
            EXPECT_THAT(text, HasSubstr(part));
    }
    expect(0, {"convert", "run.mcap", "-o", "count.nc", "--topic", "/tank/count"});
    const char* const script =
        "import sys\n"
        "try:\n  import netCDF4\n"
        "except ImportError:\n  print('none'); sys.exit(0)\n"
        "one = netCDF4.Dataset('count.nc')\n"
        "print(sorted(one.variables), list(one['data'][:]), list(one['time'][:]))\n";
    const std::string shown = read("/usr/bin/python3", {"-c", script});
    if (shown != "none\n") {
        EXPECT_EQ("['data', 'time'] [-7, 9] [2000000000, 3000000000]\n", shown);
    }
    // A long text, and no point in a list.
    std::vector<Told> large = messages();
    large.resize(1);
    std::get<3>(large[0]) = level(1, std::string(9000, 'x'), 0);
    record("large.mcap", large);
    expect(0, {"convert", "large.mcap", "-o", "large.nc"});
    EXPECT_GT(std::filesystem::file_size(directory / "large.nc"), 9000U);
}

}  // namespace
