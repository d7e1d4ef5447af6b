// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Reporters of users' own, which bring marshallers.
#include "reporter_fixture.hpp"

namespace {

using namespace components_test;

/** Writes down what it is given: "name=value " and "name{ … } ". */
class Note : public RTT::marsh::MarshallInterface {
public:
    explicit Note(std::string& text) : text_(text) {}

    void serialize(RTT::base::PropertyBase* property) override {
        if (auto* const bag = dynamic_cast<RTT::Property<RTT::PropertyBag>*>(property)) {
            text_ += property->getName() + "{ ";
            serialize(bag->rvalue());
            text_ += "} ";
        } else {
            text_ += property->getName() + "=" + property->getDataSource()->toString() + " ";
        }
    }
    void serialize(const RTT::PropertyBag& bag) override {
        for (RTT::base::PropertyBase* property : bag) serialize(property);
    }
    void flush() override { text_ += "\n"; }

private:
    std::string& text_;
};

class OwnReporter : public OCL::ReportingComponent {
public:
    using ReportingComponent::ReportingComponent;
};

class ReportMarshaller : public Reporting {
protected:
    void SetUp() override {
        Reporting::SetUp();
        own.addPeer(&machine);
        own.setActivity(new RTT::extras::SlaveActivity(0.01));
    }
    OwnReporter own{"Own"};
    std::string header, body;
};

TEST_F(ReportMarshaller, GetsTheValuesAsPropertiesInBags) {
    ASSERT_TRUE(own.addMarshaller(new Note(header), new Note(body)));
    machine.place.write({1, 2});
    machine.levels.write({5, 6});
    machine.mode.write(sample::Mode::Filling);
    for (const char* port : {"place", "levels", "mode"}) ASSERT_TRUE(own.reportPort("Machine", port));
    ASSERT_TRUE(own.start());
    machine.levels.write({7});
    own.update();
    own.stop();
    EXPECT_EQ("TimeStamp=0 Machine.place{ x=1 y=2 } Machine.levels{ 0=5 1=6 } Machine.mode=Filling \n", header);
    EXPECT_EQ(
        "TimeStamp=0 Machine.place{ x=1 y=2 } Machine.levels{ 0=5 1=6 } Machine.mode=Filling \n"
        "TimeStamp=0 Machine.place{ x=1 y=2 } Machine.levels{ 0=7 } Machine.mode=Filling \n",
        body);
}

TEST_F(ReportMarshaller, OneOfBothMayBeMissing) {
    EXPECT_FALSE(own.addMarshaller(nullptr, nullptr));
    ASSERT_TRUE(own.addMarshaller(nullptr, new Note(body)));
    ASSERT_TRUE(own.reportData("Machine", "gain"));
    ASSERT_TRUE(own.start());
    own.stop();
    EXPECT_EQ("TimeStamp=0 Machine.gain=1.5 \n", body);
    EXPECT_TRUE(own.removeMarshallers());
    EXPECT_FALSE(own.start());
}

TEST_F(ReportMarshaller, IsAddedToTheTextOfAConsole) {
    ASSERT_TRUE(reporter->addMarshaller(new Note(header), new Note(body)));
    property<bool>("ReportOnlyNewData") = true;
    ASSERT_TRUE(reporter->reportData("Machine", "gain"));
    ASSERT_TRUE(reporter->start());
    cycle();
    machine.gain = 2;
    cycle();
    EXPECT_EQ(" TimeStamp Machine.gain\n 0 1.5 \n 0.5 nan \n 1 2 \n", report());
    EXPECT_EQ("TimeStamp=0 Machine.gain=1.5 \nTimeStamp=0.5 \nTimeStamp=1 Machine.gain=2 \n", body);
}

}  // namespace
