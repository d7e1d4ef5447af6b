// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A reporter of NetCDF files in a folder of its own, and python3-netcdf4 to read them.
#ifndef OROFORGE_TESTS_COMPONENTS_NETCDF_FIXTURE_HPP
#define OROFORGE_TESTS_COMPONENTS_NETCDF_FIXTURE_HPP

#include "reporter_fixture.hpp"

#include <ocl/NetcdfReporting.hpp>
#include <rtt/Attribute.hpp>
#include <support/child_process.hpp>
#include <support/temp_dir.hpp>

#include <memory>
#include <string>

namespace components_test {

inline oroforge::test::Outcome python(const std::string& script, const std::filesystem::path& folder) {
    oroforge::test::Command command;
    command.program = PYTHON;
    command.arguments = {"-c", script};
    command.directory = folder;
    return run(command);
}

inline bool hasNetcdf() {
    static const bool has = python("import netCDF4", "/").status == 0;
    return has;
}

class NetcdfFiles : public Reporting {
protected:
    void SetUp() override {
        if (!hasNetcdf()) GTEST_SKIP() << "python3-netcdf4 is not installed";
        Reporting::SetUp();
        files = make("Files");
    }
    std::unique_ptr<OCL::NetcdfReporting> make(const std::string& name) {
        auto made = std::make_unique<OCL::NetcdfReporting>(name);
        made->addPeer(&machine);
        made->setActivity(new RTT::extras::SlaveActivity(0.01));
        set<std::string>(*made, "ReportFile", folder / "reports.nc");
        return made;
    }
    template <class T>
    static void set(OCL::ReportingComponent& component, const std::string& name, const T& value) {
        RTT::Property<T> property(component.getProperty(name));
        ASSERT_TRUE(property.ready()) << name;
        property.set(value);
    }
    void next(double seconds = 0.5) {
        RTT::os::TimeService::Instance()->secondsChange(seconds);
        files->update();
    }
    unsigned lost() { return RTT::Attribute<unsigned>(files->getAttribute("LostRows")).get(); }
    /** What python prints; `d` is the file, `v` has its variables. */
    std::string read(const std::string& script, const std::string& file = "reports.nc") const {
        const std::string begin =
            "import netCDF4\nd = netCDF4.Dataset('" + file +
            "')\nv = d.variables\ndef text(x): return [str(s) for s in netCDF4.chartostring(x[:])]\n";
        const oroforge::test::Outcome outcome = python(begin + script, folder.path());
        EXPECT_EQ(0, outcome.status) << outcome.err;
        return outcome.out;
    }

    const oroforge::test::TempDir folder;
    std::unique_ptr<OCL::NetcdfReporting> files;
};

}  // namespace components_test

#endif
