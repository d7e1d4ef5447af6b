#include "Recorder.hpp"

#include <gtest/gtest.h>

namespace {

class RecorderTest : public ::testing::Test {
protected:
    RecorderTest() { component.provides()->addService(RTT::Service::shared_ptr(new gripper::Recorder(&component))); }

    RTT::TaskContext component{"component"};
};

TEST_F(RecorderTest, IsPartOfTheComponent) {
    EXPECT_TRUE(component.provides()->hasService("recorder"));
}

TEST_F(RecorderTest, HasItsPorts) {
    EXPECT_NE(dynamic_cast<RTT::InputPort<double>*>(component.provides("recorder")->getPort("sample")), nullptr);
}

TEST_F(RecorderTest, HasItsProperties) {
    auto* size_ = dynamic_cast<RTT::Property<unsigned int>*>(component.provides("recorder")->getProperty("size"));
    ASSERT_NE(size_, nullptr);
    EXPECT_EQ(size_->get(), 100U);
    auto* file_name_ = dynamic_cast<RTT::Property<std::string>*>(component.provides("recorder")->provides("file")->getProperty("name"));
    ASSERT_NE(file_name_, nullptr);
    EXPECT_EQ(file_name_->get(), "a.txt");
}

TEST_F(RecorderTest, HasItsOperations) {
    EXPECT_TRUE(component.provides("recorder")->hasOperation("forget"));
    EXPECT_TRUE(component.provides("recorder")->hasOperation("mean"));
}

}  // namespace
