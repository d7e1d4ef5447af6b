// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What few packages do with values and types, and then rely on.
#include <rtt/Property.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/internal/DataSourceGenerator.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/FusedFunctorDataSource.hpp>
#include <rtt/internal/NA.hpp>
#include <rtt/internal/mystd.hpp>
#include <rtt/typekit/StdTypeInfo.hpp>
#include <rtt/types/OperatorTypes.hpp>
#include <rtt/types/Operators.hpp>
#include <rtt/types/TemplateConstructor.hpp>
#include <rtt/types/Types.hpp>

#include <boost/lexical_cast.hpp>

#include <gtest/gtest.h>

using namespace RTT;
using namespace RTT::detail;

namespace {

struct Blend : public std::ternary_function<double, double, double, double> {
    double operator()(double a, double b, double part) const { return a + (b - a) * part; }
};
struct Mean {
    typedef double(Signature)(double, double);
    double operator()(double a, double b) const { return (a + b) / 2; }
};
double half(double x) { return x / 2; }

struct Length {
    double metres;
};
Length metres(double m) {
    Length made = {m};
    return made;
}
Length operator*(const Length& l, double f) { return metres(l.metres * f); }
std::ostream& operator<<(std::ostream& os, const Length& l) { return os << l.metres << " m"; }
std::istream& operator>>(std::istream& is, Length& l) { return is >> l.metres; }

DataSource<double>::shared_ptr number(double value) { return new ConstantDataSource<double>(value); }

}  // namespace

TEST(UserCode, TurnsWhatABagGivesIntoAProperty) {
    PropertyBag rows("rows");
    PropertyBag* inner = new PropertyBag("row");
    inner->ownProperty(new Property<double>("0", "", 1.5));
    rows.ownProperty(new Property<PropertyBag>("row", "", *inner));
    delete inner;
    rows.ownProperty(new Property<double>("gain", "", 2.0));

    Property<double> gain = rows.getProperty("gain");
    ASSERT_TRUE(gain.ready());
    EXPECT_EQ(gain.get(), 2.0);
    gain = 3.0;
    EXPECT_EQ(rows.getPropertyType<double>("gain")->get(), 3.0) << "it is the same value";

    Property<PropertyBag> row = rows.getProperty("row");
    ASSERT_TRUE(row.ready());
    EXPECT_EQ(row.rvalue().size(), 1u);
    PropertyBag bag = rows;
    EXPECT_TRUE(row.compose(*bag.begin() == 0 ? bag : row.rvalue()));

    Property<double> missing = rows.getProperty("missing");
    EXPECT_FALSE(missing.ready());
    Property<std::string> other = rows.getProperty("gain");
    EXPECT_FALSE(other.ready()) << "of another type";
}

TEST(UserCode, UsesFunctionObjectsOfTheOldKind) {
    EXPECT_EQ(identity<double>()(2.5), 2.5);
    EXPECT_EQ((divides3<double, double, int>()(5.0, 2)), 2.5);
    EXPECT_EQ((multiplies3<double, double, int>()(5.0, 2)), 10.0);
    DataSource<double>::shared_ptr a = number(1.0), b = number(3.0), part = number(0.25);
    DataSourceBase::shared_ptr mean = newFunctorDataSource(Mean(), GenerateDataSource()(a.get(), b.get()));
    ASSERT_TRUE(mean);
    EXPECT_EQ(DataSource<double>::narrow(mean.get())->get(), 2.0);
    DataSourceBase::shared_ptr blend =
        newFunctorDataSource(Blend(), GenerateDataSource()(a.get(), b.get(), part.get()));
    ASSERT_TRUE(blend);
    EXPECT_EQ(DataSource<double>::narrow(blend.get())->get(), 1.5);
    std::vector<DataSourceBase::shared_ptr> arguments(1, b);
    DataSourceBase::shared_ptr halved = newFunctorDataSource(&half, arguments);
    EXPECT_EQ(DataSource<double>::narrow(halved.get())->get(), 1.5);
    EXPECT_EQ(NA<double>::na(), 0.0);
    EXPECT_EQ(NA<std::string>::na(), "");
    NA<double&>::na() = 1.0;
    EXPECT_FALSE(DataSource<int>::narrow(halved.get()));
}

TEST(UserCode, AddsConstructorsAndOperators) {
    types::TypeInfoRepository::shared_ptr ti = types::Types();
    ASSERT_TRUE(ti->addType(new types::StdTypeInfo<Length>("length")));
    types::TypeInfo* type = ti->type("length");
    ASSERT_TRUE(type);
    type->addConstructor(newConstructor(&metres, true));
    type->addConstructor(newConstructor(&boost::lexical_cast<Length, std::string>, false));
    ti->type("string")->addConstructor(newConstructor(&boost::lexical_cast<std::string, Length>, false));

    DataSource<Length>::shared_ptr made = DataSource<Length>::narrow(type->convert(number(2.0)).get());
    ASSERT_TRUE(made);
    EXPECT_EQ(made->get().metres, 2.0);
    std::vector<DataSourceBase::shared_ptr> arguments(1, new ConstantDataSource<std::string>("4.5"));
    DataSource<Length>::shared_ptr read = DataSource<Length>::narrow(type->construct(arguments).get());
    ASSERT_TRUE(read);
    EXPECT_EQ(read->get().metres, 4.5);

    types::OperatorRepository::shared_ptr oreg = types::operators();
    oreg->add(types::newBinaryOperator("*", multiplies3<Length, Length, double>()));
    oreg->add(types::newUnaryOperator("-", std::negate<double>()));
    DataSourceBase::shared_ptr twice = oreg->applyBinary("*", made.get(), number(2.0).get());
    ASSERT_TRUE(twice);
    EXPECT_EQ(DataSource<Length>::narrow(twice.get())->get().metres, 4.0);
}

TEST(UserCode, NamesATypeTwice) {
    types::TypeInfoRepository::shared_ptr ti = types::TypeInfoRepository::Instance();
    types::TypeInfo* known = ti->getTypeInfo<double>();
    EXPECT_TRUE(ti->addType(new types::StdTypeInfo<double>("float64")));
    EXPECT_EQ(ti->type("float64"), known);
    EXPECT_EQ(known->getTypeName(), "double");
}

TEST(UserCode, CastsValuesToText) {
    EXPECT_EQ(boost::lexical_cast<std::string>(NewData), "NewData");
    EXPECT_EQ(boost::lexical_cast<std::string>(WriteSuccess), "WriteSuccess");
    EXPECT_EQ(boost::lexical_cast<double>(Property<std::string>("text", "", "1.5").get()), 1.5);
    EXPECT_EQ(boost::lexical_cast<std::string>(Property<int>("number", "", 7).rvalue()), "7");
}
