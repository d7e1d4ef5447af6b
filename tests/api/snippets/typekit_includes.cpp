// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A typekit's members by functions: newFunctorDataSource() comes with the headers that typekits include anyway.
#include <rtt/types/TemplateConstructor.hpp>

#include <gtest/gtest.h>

namespace {

double half(double value) { return value / 2; }

}  // namespace

TEST(UserCode, HasFunctorDataSourcesFromTheHeadersOfTypekits) {
    using namespace RTT::internal;
    const std::vector<RTT::base::DataSourceBase::shared_ptr> arguments{new ConstantDataSource<double>(3.0)};
    const DataSource<double>::shared_ptr value = DataSource<double>::narrow(newFunctorDataSource(&half, arguments));
    ASSERT_TRUE(value);
    EXPECT_EQ(value->get(), 1.5);
}
