// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What typekits override and combine of the ready-made generators (spec 5.2, 5.3).
#include "builtin_typekit.hpp"

#include "../os/logger_capture.hpp"

#include <rtt/Attribute.hpp>
#include <rtt/FactoryExceptions.hpp>
#include <rtt/internal/FusedFunctorDataSource.hpp>
#include <rtt/internal/Reference.hpp>
#include <rtt/internal/SendHandleC.hpp>
#include <rtt/types/EnumTypeInfo.hpp>
#include <rtt/types/MemberFactory.hpp>
#include <rtt/types/OperatorTypes.hpp>
#include <rtt/types/PropertyDecomposition.hpp>
#include <rtt/types/StdVectorTypeInfo.hpp>
#include <rtt/types/TemplateConstructor.hpp>

#include <boost/lexical_cast.hpp>
#include <boost/make_shared.hpp>

using namespace RTT;
using namespace RTT::types;
using namespace types_test;

namespace {

struct Pair {
    double first = 1, second = 2;
};
/** Access by name, and nothing about bags. */
class PairInfo : public TemplateTypeInfo<Pair>, public MemberFactory {
public:
    PairInfo() : TemplateTypeInfo<Pair>("generator_pair") {}
    bool installTypeInfoObject(TypeInfo* info) override {
        TemplateTypeInfo<Pair>::installTypeInfoObject(info);
        info->setMemberFactory(boost::dynamic_pointer_cast<PairInfo>(getSharedPtr()));
        return false;
    }
    std::vector<std::string> getMemberNames() const override { return {"first", "second", "sum"}; }
    using MemberFactory::getMember;
    SourcePtr getMember(SourcePtr item, const std::string& name) const override {
        if (name == "sum")
            return internal::newFunctorDataSource(+[](const Pair& p) { return p.first + p.second; }, {item});
        if (name == "first") return internal::newFunctorDataSource(+[](Pair& p) -> double& { return p.first; }, {item});
        if (name == "second")
            return internal::newFunctorDataSource(+[](Pair& p) -> double& { return p.second; }, {item});
        return nullptr;
    }
    base::InputPortInterface* inputPort(const std::string& name) const override {
        return new InputPort<Pair>("my_" + name);
    }
};

/** A size and elements, and nothing about bags. */
typedef std::vector<int> Row;
class RowInfo : public TemplateTypeInfo<Row>, public MemberFactory {
public:
    RowInfo() : TemplateTypeInfo<Row>("generator_row") {}
    bool installTypeInfoObject(TypeInfo* info) override {
        TemplateTypeInfo<Row>::installTypeInfoObject(info);
        info->setMemberFactory(boost::dynamic_pointer_cast<RowInfo>(getSharedPtr()));
        return false;
    }
    std::vector<std::string> getMemberNames() const override { return {"size"}; }
    SourcePtr getMember(SourcePtr item, const std::string& name) const override {
        if (name != "size") return nullptr;
        return internal::newFunctorDataSource(+[](const Row& r) { return static_cast<int>(r.size()); }, {item});
    }
    SourcePtr getMember(SourcePtr item, SourcePtr id) const override {
        return internal::newFunctorDataSource(+[](Row& r, int i) -> int& { return r.at(static_cast<std::size_t>(i)); },
                                              {item, id});
    }
    bool resize(SourcePtr item, int size) const override {
        internal::AssignableDataSource<Row>::narrow(item.get())->set().resize(static_cast<std::size_t>(size));
        return true;
    }
};

/** Refuses what is longer than three characters. */
struct ShortText {
    std::string text;
};
class ShortTextConstructor : public TypeConstructor {
    SourcePtr build(const std::vector<SourcePtr>& arguments) const override {
        const auto* text =
            arguments.size() == 1 ? internal::DataSource<std::string>::narrow(arguments[0].get()) : nullptr;
        if (!text || text->get().size() > 3) return nullptr;
        return new internal::ValueDataSource<ShortText>(ShortText{text->get()});
    }
};

enum class Gear { Low, High };
class GearInfo : public EnumTypeInfo<Gear> {
public:
    GearInfo() : EnumTypeInfo<Gear>("generator_gear") {
        to_string[Gear::Low] = "Low";
        to_string[Gear::High] = "High";
    }
};
/** A form of its own, as a bag of one number. */
class GearAsBag : public TemplateTypeInfo<Gear> {
public:
    GearAsBag() : TemplateTypeInfo<Gear>("generator_gear_bag") {}
    bool composeTypeImpl(const PropertyBag& source, Gear& result) const override {
        const auto* gear = source.getPropertyType<int>("gear");
        if (gear) result = static_cast<Gear>(gear->rvalue());
        return gear;
    }
    bool decomposeTypeImpl(const Gear& source, PropertyBag& target) const override {
        return target.ownProperty(new Property<int>("gear", "", static_cast<int>(source)));
    }
};

/** Sets its factory before the functions of the base are installed. */
struct Early {
    int value = 0;
};
class EarlyFactory : public CompositionFactory {
    SourcePtr decomposeType(SourcePtr source) const override {
        return variable(internal::DataSource<Early>::narrow(source.get())->get().value);
    }
    bool composeType(SourcePtr source, SourcePtr target) const override {
        const auto* number = internal::DataSource<int>::narrow(source.get());
        if (number) internal::AssignableDataSource<Early>::narrow(target.get())->set().value = number->get();
        return number;
    }
};
class EarlyInfo : public TemplateTypeInfo<Early> {
public:
    EarlyInfo() : TemplateTypeInfo<Early>("generator_early") {}
    bool installTypeInfoObject(TypeInfo* info) override {
        info->setCompositionFactory(boost::make_shared<EarlyFactory>());
        return TemplateTypeInfo<Early>::installTypeInfoObject(info);
    }
};

class TypeGenerators : public WithBuiltinTypes {
protected:
    static void SetUpTestSuite() {
        WithBuiltinTypes::SetUpTestSuite();
        Types()->addType(new PairInfo());
        Types()->addType(new RowInfo());
        Types()->addType(new TemplateTypeInfo<ShortText>("generator_text"));
    }
};

}  // namespace

TEST_F(TypeGenerators, MembersAloneMakeABag) {
    const auto pair = variable(Pair());
    PropertyBag bag;
    ASSERT_TRUE(typeDecomposition(pair, bag));
    EXPECT_EQ("generator_pair", bag.getType());
    EXPECT_EQ(2u, bag.size()) << "what is computed is no part of the value";
    const auto other = variable(Pair{7, 8});
    EXPECT_TRUE(type("generator_pair")->composeType(new internal::ValueDataSource<PropertyBag>(bag), other));
    EXPECT_EQ(1, other->rvalue().first);
    bag.removeProperty(bag.find("first"));
    bag.getPropertyType<double>("second")->set(9);
    EXPECT_TRUE(type("generator_pair")->composeType(new internal::ValueDataSource<PropertyBag>(bag), other));
    EXPECT_EQ(1, other->rvalue().first) << "what the bag lacks keeps its value";
    EXPECT_EQ(9, other->rvalue().second);
    PropertyBag wrong;
    wrong.ownProperty(new Property<std::string>("first", "", "x"));
    EXPECT_FALSE(type("generator_pair")->composeType(new internal::ValueDataSource<PropertyBag>(wrong), other));
}

TEST_F(TypeGenerators, ElementsAloneMakeABag) {
    PropertyBag bag;
    ASSERT_TRUE(typeDecomposition(new internal::ConstantDataSource<Row>(Row{4, 5}), bag));
    ASSERT_EQ(2u, bag.size());
    EXPECT_EQ("Element1", bag.getItem(1)->getName());
    const auto row = variable(Row{1});
    EXPECT_TRUE(type("generator_row")->composeType(new internal::ValueDataSource<PropertyBag>(bag), row));
    EXPECT_EQ((Row{4, 5}), row->get());
}

TEST_F(TypeGenerators, ASecondOneKeepsTheFormOfTheFirst) {
    ASSERT_TRUE(Types()->addType(new GearInfo()));
    ASSERT_TRUE(Types()->addType(new TemplateTypeInfo<Gear>("generator_gear_plain")));
    const auto gear = variable(Gear::High);
    EXPECT_EQ("High", valueOf<std::string>(type("generator_gear")->decomposeType(gear)));
    EXPECT_TRUE(type("generator_gear")->composeType(variable("Low"), gear));
    EXPECT_EQ(Gear::Low, gear->get());
    EXPECT_FALSE(type("generator_gear")->composeType(variable(PropertyBag()), gear));

    ASSERT_TRUE(Types()->addType(new GearAsBag()));
    const SourcePtr bag = type("generator_gear")->decomposeType(variable(Gear::High));
    ASSERT_TRUE(internal::DataSource<PropertyBag>::narrow(bag.get())) << "what it overrides is in use";
    EXPECT_TRUE(type("generator_gear")->composeType(bag, gear));
    EXPECT_EQ(Gear::High, gear->get());
    EXPECT_TRUE(type("generator_gear")->composeType(variable("Low"), gear)) << "the text is still known";
    EXPECT_EQ(Gear::Low, gear->get());

    ASSERT_TRUE(Types()->addType(new TemplateTypeInfo<Gear>("generator_gear_third")));
    EXPECT_TRUE(type("generator_gear")->composeType(bag, gear));
    EXPECT_EQ(Gear::High, gear->get());
    EXPECT_FALSE(type("generator_gear")->composeType(variable(PropertyBag()), gear));
}

TEST_F(TypeGenerators, AFactoryThatWasSetFirstStays) {
    ASSERT_TRUE(Types()->addType(new EarlyInfo()));
    const auto early = variable(Early{3});
    EXPECT_EQ(3, valueOf<int>(type("generator_early")->decomposeType(early)));
    EXPECT_TRUE(type("generator_early")->composeType(variable(4), early));
    EXPECT_EQ(4, early->rvalue().value);
}

TEST_F(TypeGenerators, DotOperatorsAddMembersToContainers) {
    const auto values = variable(std::vector<double>{4, 5});
    oroforge::test::LoggerCapture log;
    EXPECT_FALSE(values->getMember("generator_last"));
    EXPECT_EQ(1, log.count("no member generator_last"));
    operators()->add(newDotOperator(
        "generator_last", +[](const std::vector<double>& v) { return v.back(); }));
    EXPECT_EQ(5, valueOf<double>(values->getMember("generator_last")));
    EXPECT_EQ(5, valueOf<double>(values->getMember(variable("generator_last"))));
    EXPECT_EQ(1, log.count("no member generator_last")) << "what was found is no error";
}

TEST_F(TypeGenerators, SourcesOfFunctionsCheckTheirArguments) {
    typedef std::vector<SourcePtr> Arguments;
    typedef internal::FusedFunctorDataSource<int(int, int&)> Sum;
    const auto sum = [](int a, int& b) { return b += a; };
    const auto total = variable(1);
    const SourcePtr source(new Sum(sum, Arguments{variable(2u), total}));
    EXPECT_EQ(3, valueOf<int>(source)) << "converted";
    EXPECT_EQ(3, total->get());
    EXPECT_THROW((void)new Sum(sum, Arguments{variable(2)}), wrong_number_of_args_exception);
    EXPECT_THROW((void)new Sum(sum, Arguments{variable(2), total, total}), wrong_number_of_args_exception);
    EXPECT_THROW((void)new Sum(sum, Arguments{nullptr, total}), wrong_types_of_args_exception);
    EXPECT_THROW((void)new Sum(sum, Arguments{variable(2), variable(1u)}), wrong_types_of_args_exception);
    const SourcePtr fixed(new internal::ConstantDataSource<int>(1));
    EXPECT_THROW((void)new Sum(sum, Arguments{variable(2), fixed}), non_lvalue_args_exception);
    try {
        (void)new Sum(sum, Arguments{variable("two"), total});
        FAIL();
    } catch (const wrong_types_of_args_exception& wrong) {
        EXPECT_EQ(1, wrong.whicharg);
        EXPECT_EQ("int", wrong.expected_);
        EXPECT_EQ("string", wrong.received_);
    }
}

TEST_F(TypeGenerators, PortsCanBeOverridden) {
    const std::unique_ptr<base::InputPortInterface> port(type("generator_pair")->inputPort("in"));
    EXPECT_EQ("my_in", port->getName());
    EXPECT_TRUE(type("generator_pair")->getPortFactory());
    EXPECT_FALSE(type("TaskContext")->getPortFactory()) << "a primitive type";
}

TEST_F(TypeGenerators, AReferenceIsLedToAMember) {
    const auto pair = variable(Pair{3, 4});
    double elsewhere = 0;
    internal::ReferenceDataSource<double>::shared_ptr reference(new internal::ReferenceDataSource<double>(elsewhere));
    EXPECT_TRUE(type("generator_pair")->getMember(reference.get(), pair, "second"));
    EXPECT_EQ(4, reference->get());
    reference->set(5);
    EXPECT_EQ(5, pair->rvalue().second);
    EXPECT_FALSE(type("generator_pair")->getMember(reference.get(), pair, "third"));
    EXPECT_FALSE(type("generator_pair")->getMember(reference.get(), pair, "sum")) << "cannot be changed";
    int number = 0;
    internal::ReferenceDataSource<int>::shared_ptr other(new internal::ReferenceDataSource<int>(number));
    EXPECT_FALSE(type("generator_pair")->getMember(other.get(), pair, "second")) << "of another type";
}

TEST_F(TypeGenerators, CompatibleTypes) {
    EXPECT_EQ(-3, valueOf<int>(type("int16")->convertType(variable(short(-3)))));
    const auto number = variable(2.5);
    EXPECT_EQ(number, type("double")->convertType(number)) << "the most common one already";
    const auto target = variable(0);
    EXPECT_TRUE(type("int")->convertType(variable(7u), target));
    EXPECT_EQ(7, target->get());
}

TEST_F(TypeGenerators, VariablesOfContainersAndStringsTakeASize) {
    const std::unique_ptr<base::AttributeBase> array(type("array")->buildVariable("a", 3));
    EXPECT_EQ("{0, 0, 0}", array->getDataSource()->toString());
    const std::unique_ptr<base::AttributeBase> text(type("string")->buildVariable("s", 3));
    EXPECT_EQ(std::string(3, '\0'), text->getDataSource()->toString());
    const std::unique_ptr<base::AttributeBase> realTime(type("rt_string")->buildVariable("s", 3));
    EXPECT_EQ(std::string(3, '\0'), realTime->getDataSource()->toString());
    const std::unique_ptr<base::AttributeBase> number(type("int")->buildVariable("i", 3));
    EXPECT_EQ("0", number->getDataSource()->toString()) << "no container";
}

TEST_F(TypeGenerators, VectorsOfOtherElements) {
    ASSERT_TRUE(Types()->addType(new StdVectorTypeInfo<float>("generator_floats")));
    const SourcePtr floats = type("generator_floats")->construct({variable(2), variable(1.5f)});
    ASSERT_TRUE(floats && floats->evaluate());
    EXPECT_EQ("{1.5, 1.5}", floats->toString());
}

TEST_F(TypeGenerators, ConstructorsByClass) {
    type("generator_text")->addConstructor(new ShortTextConstructor());
    EXPECT_TRUE(type("generator_text")->construct({variable("abc")}));
    EXPECT_FALSE(type("generator_text")->construct({variable("abcd")}));
    const auto join = [](const std::string& a, char b) { return ShortText{a + b}; };
    type("generator_text")->addConstructor(new TemplateConstructor<ShortText(std::string, char)>(join));
    EXPECT_EQ("ab", valueOf<ShortText>(type("generator_text")->construct({variable("a"), variable('b')})).text);
}

TEST_F(TypeGenerators, ConstructorsAreTriedInTheOrderTheyWereAdded) {
    struct Which {
        int value = 0;
    };
    Types()->addType(new TemplateTypeInfo<Which>("generator_which"));
    type("generator_which")
        ->addConstructor(newConstructor(
            +[](double) { return Which{1}; }, true));
    type("generator_which")
        ->addConstructor(newConstructor(
            +[](double) { return Which{2}; }, true));
    EXPECT_EQ(1, valueOf<Which>(type("generator_which")->construct({variable(0.5)})).value);
    EXPECT_EQ(1, valueOf<Which>(type("generator_which")->convert(variable(0.5))).value);
    // A second registration of the same C++ type adds a name and keeps the constructors.
    Types()->addType(new TemplateTypeInfo<Which>("generator_which_else"));
    EXPECT_EQ(1, valueOf<Which>(type("generator_which_else")->construct({variable(0.5)})).value);
}

TEST_F(TypeGenerators, LexicalCastsAreConstructors) {
    struct Text : std::string {};
    Types()->addType(new TemplateTypeInfo<Text>("generator_lexical"));
    const auto text = variable(Text());
    text->set().assign("2.5");
    type("double")->addConstructor(newConstructor(boost::lexical_cast<double, Text>, false));
    const SourcePtr number = type("double")->construct({text});
    EXPECT_EQ(2.5, valueOf<double>(number));
    text->set().assign("two");
    EXPECT_FALSE(number->evaluate()) << "what the function throws is a failure, and reported";
    EXPECT_FALSE(variable(0.0)->update(number.get()));
}

TEST_F(TypeGenerators, SendHandlesCanBeNamed) {
    EXPECT_EQ("SendHandle", internal::DataSourceTypeInfo<internal::SendHandleC>::getTypeName());
    const std::unique_ptr<base::AttributeBase> handle(type("SendHandle")->buildVariable("h"));
    EXPECT_TRUE(handle && handle->getDataSource()->isAssignable());
}
