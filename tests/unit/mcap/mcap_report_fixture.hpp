// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A recorder that the test steps itself, and what is in its files.
#ifndef OROFORGE_TESTS_MCAP_REPORT_FIXTURE_HPP
#define OROFORGE_TESTS_MCAP_REPORT_FIXTURE_HPP

#include "mcap_files.hpp"

#include <components/reporter_fixture.hpp>
#include <ocl/McapReporting.hpp>
#include <rtt/ConnPolicy.hpp>
#include <support/golden.hpp>
#include <support/temp_dir.hpp>

namespace mcap_test {

using components_test::LogText;
using testing::HasSubstr;

class Recorder : public components_test::Reporting {
protected:
    void SetUp() override {
        RTT::os::TimeService::Instance()->enableSystemClock(false);
        recorder.reset(new OCL::McapReporting("Recorder"));
        recorder->addPeer(&machine);
        recorder->setActivity(new RTT::extras::SlaveActivity(0.01));
        set<std::string>("ReportFile", file("run.mcap"));
        set<std::string>("Clock", "component");
        set<std::string>("Compression", "none");
        set("States", false);
        set("Log", false);
    }
    void TearDown() override {
        recorder.reset();
        Reporting::TearDown();
    }

    std::string file(const std::string& name) const { return (directory / name).string(); }
    template <class T>
    void set(const std::string& name, const T& value) {
        auto* const found = dynamic_cast<RTT::Property<T>*>(recorder->getProperty(name));
        ASSERT_TRUE(found) << name;
        found->set(value);
    }
    void step(double seconds = 0.01) {
        RTT::os::TimeService::Instance()->secondsChange(seconds);
        recorder->update();
    }
    Found read(const std::string& name = "run.mcap") const {
        const std::string bytes = oroforge::test::readFile(directory / name);
        return Found(Bytes(bytes.begin(), bytes.end()));
    }
    /** The numbers in all messages of doubles of that topic. */
    static std::vector<double> numbersOf(const Found& found, const std::string& topic) {
        std::vector<double> numbers;
        for (const auto& [channel, sequence, time, data] : found.messages) {
            if (found.channels.at(channel - 1U).topic != topic) continue;
            EXPECT_EQ(12U, data.size());
            double number = 0;
            std::memcpy(&number, data.data() + 4, sizeof number);
            numbers.push_back(number);
        }
        return numbers;
    }

    oroforge::test::TempDir directory;
    std::unique_ptr<OCL::McapReporting> recorder;
};

}  // namespace mcap_test

#endif
