// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The service as C++ components use it.
#include "param_fixture.hpp"

#include <rtt_rosparam/rosparam.h>

namespace param_test {

class ParameterRequester : public WithMaster {};

TEST_F(ParameterRequester, HasAllOperations) {
    const auto rosparam = component_.getProvider<rtt_rosparam::ROSParam>("rosparam");
    ASSERT_NE(nullptr, rosparam);
    EXPECT_TRUE(rosparam->ready()) << rosparam->missingOperations();
    EXPECT_EQ(component_.provides("rosparam")->getOperationNames().size(), rosparam->getOperationCallerNames().size());
    int value = 3;
    component_.addProperty("p", value);
    EXPECT_TRUE(rosparam->setAll());
    EXPECT_TRUE(rosparam->set("p", rtt_rosparam::ABSOLUTE));
    EXPECT_TRUE(rosparam->get("p", rosparam->COMPONENT_PRIVATE));
    EXPECT_TRUE(rosparam->get("p", rtt_rosparam::ROSParam::COMPONENT));
    std::string text;
    EXPECT_FALSE(rosparam->getString("p", text));
    rosparam->setStringPrivate("text", "a");
    EXPECT_TRUE(rosparam->getStringPrivate("text", text));
    EXPECT_EQ("a", text);
    Eigen::VectorXd vector;
    rosparam->setEigenVectorXdPrivate("v", Eigen::Vector2d(1, 2));
    EXPECT_TRUE(rosparam->getEigenVectorXdPrivate("v", vector));
    EXPECT_EQ(Eigen::Vector2d(1, 2), vector);
    RTT::Property<Eigen::VectorXd>& property = rosparam->addRosParamPropertyEigenVectorXdPrivate("v");
    EXPECT_EQ(Eigen::Vector2d(1, 2), property.get());
    EXPECT_EQ(&property, component_.getProperty("v"));
}

TEST_F(ParameterRequester, ComponentsThatGoAway) {
    boost::shared_ptr<rtt_rosparam::ROSParam> rosparam;
    {
        RTT::TaskContext short_lived("d");
        rosparam = short_lived.getProvider<rtt_rosparam::ROSParam>("rosparam");
        ASSERT_TRUE(rosparam && rosparam->ready());
        (void)rosparam->addRosParamPropertyInt("p");
    }
    rosparam.reset();
}

}  // namespace param_test
