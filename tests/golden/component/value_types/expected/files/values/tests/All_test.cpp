#include "All.hpp"

#include <gtest/gtest.h>

#include <rtt/extras/ComponentHarness.hpp>

namespace {

TEST(All, CanBeMade) {
    values::All component("component");

    EXPECT_EQ(component.getName(), "component");
    EXPECT_EQ(component.getTaskState(), values::All::Stopped);
}

TEST(All, HasItsPorts) {
    values::All component("component");

    EXPECT_NE(dynamic_cast<RTT::OutputPort<std::vector<double>>*>(component.getPort("list")), nullptr);
}

TEST(All, HasItsProperties) {
    values::All component("component");

    auto* flag_ = dynamic_cast<RTT::Property<bool>*>(component.getProperty("flag"));
    ASSERT_NE(flag_, nullptr);
    EXPECT_EQ(flag_->get(), true);
    auto* letter_ = dynamic_cast<RTT::Property<char>*>(component.getProperty("letter"));
    ASSERT_NE(letter_, nullptr);
    EXPECT_EQ(letter_->get(), 'x');
    auto* text_ = dynamic_cast<RTT::Property<std::string>*>(component.getProperty("text"));
    ASSERT_NE(text_, nullptr);
    EXPECT_EQ(text_->get(), "say \"hi\"");
    auto* tiny_ = dynamic_cast<RTT::Property<std::int8_t>*>(component.getProperty("tiny"));
    ASSERT_NE(tiny_, nullptr);
    EXPECT_EQ(tiny_->get(), -5);
    auto* byte_ = dynamic_cast<RTT::Property<unsigned char>*>(component.getProperty("byte"));
    ASSERT_NE(byte_, nullptr);
    EXPECT_EQ(byte_->get(), 200U);
    auto* count_ = dynamic_cast<RTT::Property<unsigned int>*>(component.getProperty("count"));
    ASSERT_NE(count_, nullptr);
    EXPECT_EQ(count_->get(), 3U);
    auto* big_ = dynamic_cast<RTT::Property<std::int64_t>*>(component.getProperty("big"));
    ASSERT_NE(big_, nullptr);
    EXPECT_EQ(big_->get(), -9000000000);
    auto* huge_ = dynamic_cast<RTT::Property<std::uint64_t>*>(component.getProperty("huge"));
    ASSERT_NE(huge_, nullptr);
    EXPECT_EQ(huge_->get(), 18446744073709551615U);
    auto* ratio_ = dynamic_cast<RTT::Property<float>*>(component.getProperty("ratio"));
    ASSERT_NE(ratio_, nullptr);
    EXPECT_EQ(ratio_->get(), 0.1F);
    auto* whole_ = dynamic_cast<RTT::Property<double>*>(component.getProperty("whole"));
    ASSERT_NE(whole_, nullptr);
    EXPECT_EQ(whole_->get(), 2.0);
    auto* numbers_ = dynamic_cast<RTT::Property<std::vector<double>>*>(component.getProperty("numbers"));
    ASSERT_NE(numbers_, nullptr);
}

TEST(All, HasItsAttributes) {
    values::All component("component");

    EXPECT_NE(component.getAttribute("cycles"), nullptr);
    EXPECT_NE(component.getAttribute("label"), nullptr);
    EXPECT_NE(component.getAttribute("samples"), nullptr);
}

TEST(All, RunsStepByStep) {
    values::All component("component");
    RTT::extras::ComponentHarness harness(component);
    harness.output<std::vector<double>>("list");

    ASSERT_TRUE(harness.start());
    harness.step();
    EXPECT_TRUE(component.isRunning());

    // The probes above return what the test goes on with: .write(sample) of an input, .last() and .all() of an output;
    // harness.call<double(int)>("operation", 1) calls, harness.step(0.5) lets half a second pass.

    ASSERT_TRUE(component.stop());
    EXPECT_TRUE(component.cleanup());
    EXPECT_EQ(component.getTaskState(), values::All::PreOperational);
}

}  // namespace
