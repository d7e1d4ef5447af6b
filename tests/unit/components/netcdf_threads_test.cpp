// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Two reporters of NetCDF files, each in its own thread, while others write.
#include "repeated.hpp"
#include "reporter_fixture.hpp"

#include <ocl/NetcdfReporting.hpp>
#include <rtt/Activity.hpp>
#include <rtt/Attribute.hpp>
#include <support/temp_dir.hpp>

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace components_test;

class NetcdfThreads : public Reporting {};

TEST_F(NetcdfThreads, TwoFilesGrowAtTheSameTime) {
    const oroforge::test::TempDir folder;
    std::vector<std::unique_ptr<OCL::NetcdfReporting>> files;
    for (const char* name : {"one", "other"}) {
        files.push_back(std::make_unique<OCL::NetcdfReporting>(name));
        files.back()->addPeer(&machine);
        files.back()->setActivity(new RTT::Activity(ORO_SCHED_OTHER, 0, 0.001, nullptr, name));
        RTT::Property<std::string>(files.back()->getProperty("ReportFile")).set(folder / (std::string(name) + ".nc"));
        for (const char* port : {"speed", "levels"}) ASSERT_TRUE(files.back()->reportPort("Machine", port));
    }
    for (int round = 0; round < 3; ++round) {
        for (const auto& each : files) ASSERT_TRUE(each->start());
        std::vector<double> levels;
        const Repeated writer([&] {
            machine.speed.write(1);
            levels.resize((levels.size() + 1) % 300);
            machine.levels.write(levels);
        });
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        for (const auto& each : files) {
            EXPECT_TRUE(each->stop());
            EXPECT_EQ(0u, RTT::Attribute<unsigned>(each->getAttribute("LostRows")).get());
        }
    }
    EXPECT_EQ(0u, oroforge::test::readFile(folder / "one.nc").find("CDF\x05"));
}

}  // namespace
