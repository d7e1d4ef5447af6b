// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Properties, attributes, data sources, assignments, signals: no allocation and no lock where their headers say so.
#include <support/real_time_trap.hpp>

#include <rtt/Attribute.hpp>
#include <rtt/Property.hpp>
#include <rtt/internal/AssignCommand.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/Signal.hpp>
#include <rtt/types/TypeOps.hpp>

#include <gtest/gtest.h>
#include <string>
#include <vector>

using namespace RTT;
using namespace RTT::internal;
using oroforge::test::expectRealTime;

namespace {

class RealTimeValues : public testing::Test {
protected:
    void SetUp() override { OROFORGE_NEEDS_REAL_TIME_TRAP(); }
    const std::vector<double> sample = std::vector<double>(100, 1.5);
};

}  // namespace

TEST_F(RealTimeValues, PropertiesAreReadAndSet) {
    Property<double> number("number", "", 1.0);
    Property<std::vector<double>> list("list", "", sample);
    double sum = 0;
    expectRealTime([&] {
        number = 2.0;
        number.set(number.get() + 1);
        sum = number.rvalue() + number.value();
        list.set(sample);
        list.set()[3] = 7;
        sum += list.rvalue()[3];
    });
    EXPECT_EQ(sum, 13);
}

TEST_F(RealTimeValues, AttributesAndConstantsAreReadAndSet) {
    Attribute<int> number("number", 1);
    Constant<int> fixed("fixed", 5);
    Attribute<std::vector<double>> list("list", sample);
    int sum = 0;
    expectRealTime([&] {
        number.set(3);
        number.set(number.get() + fixed.get());
        list.set(sample);
        sum = number.get();
    });
    EXPECT_EQ(sum, 8);
}

TEST_F(RealTimeValues, DataSourcesAreReadAndWritten) {
    double variable = 1;
    ValueDataSource<double>::shared_ptr value(new ValueDataSource<double>(2));
    ConstantDataSource<double>::shared_ptr constant(new ConstantDataSource<double>(3));
    ReferenceDataSource<double>::shared_ptr reference(new ReferenceDataSource<double>(variable));
    ValueDataSource<std::vector<double>>::shared_ptr list(new ValueDataSource<std::vector<double>>(sample));
    expectRealTime([&] {
        value->set(value->get() + constant->get());
        reference->set(value->rvalue());
        list->set(sample);
        base::DataSourceBase::shared_ptr erased = reference;
        EXPECT_TRUE(erased->evaluate());
        EXPECT_TRUE(value->update(constant.get()));
        EXPECT_EQ(DataSource<double>::narrow(erased.get()), reference.get());
        value->reset();
    });
    EXPECT_EQ(variable, 5);
    EXPECT_EQ(value->get(), 3);
}

TEST_F(RealTimeValues, AssignmentsAreExecuted) {
    ValueDataSource<std::vector<double>>::shared_ptr from(new ValueDataSource<std::vector<double>>(sample));
    ValueDataSource<std::vector<double>>::shared_ptr to(new ValueDataSource<std::vector<double>>(sample));
    AssignCommand<std::vector<double>> assign(to, from);
    from->set()[1] = 9;
    expectRealTime([&] {
        assign.readArguments();
        EXPECT_TRUE(assign.execute());
        assign.reset();
    });
    EXPECT_EQ(to->rvalue()[1], 9);
}

TEST_F(RealTimeValues, SignalsAreEmitted) {
    Signal<void(int, const std::vector<double>&)> signal;
    double sum = 0;
    Handle first = signal.connect([&](int n, const std::vector<double>& v) { sum += n + v[0]; });
    Handle second = signal.connect([&](int, const std::vector<double>& v) { sum += v[1]; });
    signal.emit(0, sample);
    expectRealTime([&] {
        signal.emit(1, sample);
        signal(2, sample);
        EXPECT_TRUE(first.connected());
    });
    EXPECT_EQ(sum, 12);
    expectRealTime([] { Signal<void(int)>::shared_ptr none; });
}

TEST_F(RealTimeValues, TypeTablesAreFound) {
    expectRealTime([] {
        EXPECT_EQ(types::typeOps<double>().size, sizeof(double));
        EXPECT_FALSE(types::typeOps<std::string>().trivial);
    });
}
