// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The registries of types, as services use them that show what there is.
#include <rtt/RTT.hpp>
#include <rtt/base/DataSourceBase.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/PartDataSource.hpp>
#include <rtt/typekit/RealTimeTypekit.hpp>
#include <rtt/types/GlobalsRepository.hpp>
#include <rtt/types/Operators.hpp>
#include <rtt/types/SequenceTypeInfo.hpp>
#include <rtt/types/TypekitRepository.hpp>
#include <rtt/types/Types.hpp>
#include <rtt/types/carray.hpp>

#include <boost/scoped_ptr.hpp>

#include <gtest/gtest.h>

using namespace RTT;
using namespace RTT::types;
using namespace RTT::base;
using namespace RTT::internal;

TEST(UserCode, BuildsWhatItKnowsByName) {
    TypeInfoRepository::shared_ptr types = TypeInfoRepository::Instance();
    std::vector<std::string> names = types->getTypes();
    EXPECT_NE(std::find(names.begin(), names.end(), "double"), names.end());
    const TypeInfo* type = types->type("array");
    ASSERT_TRUE(type);
    EXPECT_EQ(type, types->getTypeInfo<std::vector<double>>());
    EXPECT_EQ(*type->getTypeId(), typeid(std::vector<double>));
    EXPECT_EQ(type->getTypeName(), "array");

    DataSourceBase::shared_ptr value = type->buildValue();
    ASSERT_TRUE(value);
    EXPECT_TRUE(type->resize(value, 3));
    std::vector<std::string> members = value->getMemberNames();
    EXPECT_NE(std::find(members.begin(), members.end(), "size"), members.end());
    DataSource<int>::shared_ptr size = DataSource<int>::narrow(value->getMember("size").get());
    ASSERT_TRUE(size);
    EXPECT_EQ(size->get(), 3);
    DataSourceBase::shared_ptr index(new ConstantDataSource<int>(1));
    AssignableDataSource<double>::shared_ptr second =
        AssignableDataSource<double>::narrow(value->getMember(index).get());
    ASSERT_TRUE(second && second->isAssignable());
    second->set(4.5);
    EXPECT_EQ((ValueDataSource<std::vector<double>>::shared_ptr(
                   dynamic_cast<ValueDataSource<std::vector<double>>*>(value.get())))
                  ->rvalue()[1],
              4.5);

    boost::scoped_ptr<PropertyBase> property(type->buildProperty("p", "a property", value));
    EXPECT_EQ(property->getType(), "array");
    boost::scoped_ptr<AttributeBase> attribute(type->buildAttribute("a"));
    EXPECT_TRUE(attribute->ready());
    boost::scoped_ptr<AttributeBase> alias(type->buildAlias("b", value));
    EXPECT_EQ(alias->getDataSource(), value);
    boost::scoped_ptr<AttributeBase> variable(type->buildVariable("v", 5));
    boost::scoped_ptr<AttributeBase> constant(type->buildConstant("c", value, 3));
    EXPECT_TRUE(variable && constant);
    boost::scoped_ptr<InputPortInterface> in(type->inputPort("in"));
    boost::scoped_ptr<OutputPortInterface> out(type->outputPort("out"));
    EXPECT_TRUE(in->connectTo(out.get()));
    EXPECT_TRUE(type->getMemberFactory());
    EXPECT_FALSE(type->hasProtocol(4711));
}

TEST(UserCode, ConvertsAndComputes) {
    DataSourceBase::shared_ptr number(new ConstantDataSource<int>(3));
    const TypeInfo* type = Types()->getTypeInfo<double>();
    DataSource<double>::shared_ptr converted = DataSource<double>::narrow(type->convert(number).get());
    ASSERT_TRUE(converted);
    EXPECT_EQ(converted->get(), 3.0);
    DataSourceBase::shared_ptr sum = operators()->applyBinary("+", converted.get(), converted.get());
    ASSERT_TRUE(sum);
    EXPECT_EQ(DataSource<double>::narrow(sum.get())->get(), 6.0);
    double variable = 0.0;
    DataSourceBase::shared_ptr reference(new ReferenceDataSource<double>(variable));
    EXPECT_TRUE(reference->update(sum.get()));
    EXPECT_EQ(variable, 6.0);
    boost::scoped_ptr<ActionInterface> assign(reference->updateAction(converted.get()));
    assign->readArguments();
    EXPECT_TRUE(assign->execute());
    EXPECT_EQ(variable, 3.0);
    DataSourceBase::shared_ptr texts(new ConstantDataSource<std::vector<std::string>>(std::vector<std::string>()));
    EXPECT_THROW(reference->updateAction(texts.get()), bad_assignment);
    std::stringstream text;
    text << reference << " " << reference->getTypeName() << " " << reference->getType();
    EXPECT_EQ(text.str(), "3 double double");
    std::vector<DataSourceBase::shared_ptr> none;
    EXPECT_TRUE(type->construct(none));
    EXPECT_EQ(DataSourceTypeInfo<double>::getTypeInfo(), type);
    EXPECT_EQ(DataSource<double>::GetTypeInfo(), type);
    EXPECT_EQ(DataSourceTypeInfo<const std::string&>::getType(), "string const&");
}

TEST(UserCode, SharesPartsOfAValue) {
    ValueDataSource<std::pair<double, int>>::shared_ptr whole(
        new ValueDataSource<std::pair<double, int>>(std::make_pair(1.5, 2)));
    PartDataSource<int>::shared_ptr part(new PartDataSource<int>(whole->set().second, whole));
    part->set(7);
    EXPECT_EQ(whole->get().second, 7);
    EXPECT_EQ(part->getParent(), whole);
    int numbers[3] = {1, 2, 3};
    carray<int> view(numbers);
    view[1] = 5;
    EXPECT_EQ(numbers[1], 5);
    EXPECT_EQ(view.count(), 3u);
}

TEST(UserCode, AddsGlobals) {
    GlobalsRepository::shared_ptr globals = GlobalsRepository::Instance();
    globals->setValue(new Constant<int>("ORO_SNIPPET_ID", 42));
    ASSERT_TRUE(globals->hasAttribute("ORO_SNIPPET_ID"));
    EXPECT_EQ(Constant<int>(globals->getValue("ORO_SNIPPET_ID")).get(), 42);
    EXPECT_TRUE(globals->removeAttribute("ORO_SNIPPET_ID"));
    EXPECT_TRUE(TypekitRepository::hasTypekit("rtt-types"));
}
