// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The simpler forms of values for property files, of types whose generators say little about them, and old files.
#include "cpf_fixture.hpp"

#include <cpf/property_file.hpp>
#include <rtt/internal/FusedFunctorDataSource.hpp>
#include <rtt/types/ContainerTable.hpp>
#include <rtt/types/EnumTypeInfo.hpp>
#include <rtt/types/MemberFactory.hpp>
#include <rtt/types/PropertyDecomposition.hpp>
#include <rtt/types/SequenceTypeInfo.hpp>

#include <gmock/gmock.h>

#include <istream>
#include <ostream>
#include <set>

using namespace RTT;
using namespace RTT::marsh;
using namespace RTT::types;
using namespace types_test;
using testing::HasSubstr;

namespace {

/** A text form, a size and elements, and nothing about bags: as joint arrays are. */
struct Joints {
    std::vector<double> angles;
};
std::ostream& operator<<(std::ostream& os, const Joints& joints) {
    for (const double angle : joints.angles) os << angle << ' ';
    return os;
}
std::istream& operator>>(std::istream& is, Joints& joints) {
    joints.angles.clear();
    for (double angle; is >> angle;) joints.angles.push_back(angle);
    return is;
}
class JointsInfo : public TemplateTypeInfo<Joints, true>, public MemberFactory {
public:
    JointsInfo() : TemplateTypeInfo<Joints, true>("form_joints") {}
    bool installTypeInfoObject(TypeInfo* info) override {
        TemplateTypeInfo<Joints, true>::installTypeInfoObject(info);
        info->setMemberFactory(boost::dynamic_pointer_cast<JointsInfo>(getSharedPtr()));
        return false;
    }
    std::vector<std::string> getMemberNames() const override { return {"size", "capacity"}; }
    SourcePtr getMember(SourcePtr item, const std::string&) const override {
        return internal::newFunctorDataSource(+[](const Joints& j) { return static_cast<unsigned>(j.angles.size()); },
                                              {item});
    }
    SourcePtr getMember(SourcePtr item, SourcePtr id) const override {
        if (item->isAssignable())
            return internal::newFunctorDataSource(
                +[](Joints& j, int i) -> double& { return j.angles.at(static_cast<std::size_t>(i)); }, {item, id});
        return internal::newFunctorDataSource(
            +[](const Joints& j, int i) { return j.angles.at(static_cast<std::size_t>(i)); }, {item, id});
    }
    bool resize(SourcePtr item, int size) const override {
        internal::AssignableDataSource<Joints>::narrow(item.get())->set().angles.resize(static_cast<std::size_t>(size));
        return true;
    }
};

/** Words with a size and letters are texts. */
struct Word : std::string {};
class WordInfo : public TemplateTypeInfo<Word, true>, public SequenceTypeInfoBase<Word> {
public:
    WordInfo() : TemplateTypeInfo<Word, true>("form_word") {}
    bool installTypeInfoObject(TypeInfo* info) override {
        TemplateTypeInfo<Word, true>::installTypeInfoObject(info);
        info->setMemberFactory(boost::dynamic_pointer_cast<WordInfo>(getSharedPtr()));
        return false;
    }
};

/** No names, and one that has some. */
enum class Slot { First };
enum Flags : int { NoFlag, OneFlag };
class FlagsInfo : public EnumTypeInfo<Flags> {
public:
    FlagsInfo() : EnumTypeInfo<Flags>("form_flags") { to_string[OneFlag] = "One"; }
};

enum class Options { Left = 1, Right = 2, Up = 4 };
constexpr Enumerator optionValues[] = {{"Left", 1, ""}, {"Right", 2, ""}, {"Up", 4, ""}};

class SimplerForms : public Cpf {
protected:
    static void SetUpTestSuite() {
        Cpf::SetUpTestSuite();
        Types()->addType(new JointsInfo());
        Types()->addType(new WordInfo());
        Types()->addType(new EnumTypeInfo<Slot>("form_slot"));
        Types()->addType(new FlagsInfo());
        Types()->addType(makeEnumType<Options>("form_options", optionValues, 3));
        Types()->addType(makeSequenceType<std::set<int>>("form_set", keyedOps<std::set<int>>()));
    }
    /** The property of the bag after it was saved, changed to `other`, and loaded. */
    template <class T>
    T loadedOver(const T& other, SaveMode mode = SaveMode::store) {
        Property<T>& property = *bag.getPropertyType<T>("p");
        EXPECT_TRUE(saveToFile(bag, file, mode, sink)) << said();
        property.set(other);
        EXPECT_TRUE(loadFromFile(bag, file, LoadMode::strictRefresh, sink)) << said() << get();
        return property.get();
    }
    /** A sequence as old files have it. */
    static std::string withSize(const std::string& type, const std::string& size, const std::string& elements) {
        return "<struct name=\"p\" type=\"" + type + "\"><simple name=\"Size\" type=\"long\"><value>" + size +
               "</value></simple>" + elements + "</struct>";
    }
    static std::string number(const std::string& name, const std::string& value) {
        return "<simple name=\"" + name + "\" type=\"double\"><value>" + value + "</value></simple>";
    }
    bool load() { return loadFromFile(bag, file, LoadMode::refresh, sink); }
};

}  // namespace

TEST_F(SimplerForms, ATextFormIsNoObstacleToABagOfElements) {
    const auto joints = variable(Joints{{1, 2}});
    PropertyBag bag;
    ASSERT_TRUE(typeDecomposition(joints, bag));
    EXPECT_EQ("form_joints", bag.getType());
    EXPECT_EQ((std::vector<std::string>{"Element0", "Element1"}), bag.list());
    bag.getPropertyType<double>("Element1")->set(3);
    EXPECT_EQ(3, joints->rvalue().angles[1]) << "the elements are live";
    const auto other = variable(Joints());
    EXPECT_TRUE(type("form_joints")->composeType(new internal::ValueDataSource<PropertyBag>(bag), other));
    EXPECT_EQ((std::vector<double>{1, 3}), other->rvalue().angles);
    PropertyBag empty;
    EXPECT_TRUE(typeDecomposition(variable(Joints()), empty));
    EXPECT_TRUE(empty.empty());
    EXPECT_TRUE(type("form_joints")->composeType(new internal::ValueDataSource<PropertyBag>(empty), other));
    EXPECT_TRUE(other->rvalue().angles.empty());
    PropertyBag fixed;
    EXPECT_TRUE(typeDecomposition(new internal::ConstantDataSource<Joints>(Joints{{4}}), fixed));
    EXPECT_EQ(4, valueOf<double>(fixed.getItem(0)->getDataSource()));
}

TEST_F(SimplerForms, TextsAreNotMadeOfTheirLetters) {
    PropertyBag bag;
    EXPECT_FALSE(typeDecomposition(variable(Word()), bag));
    EXPECT_FALSE(typeDecomposition(variable("text"), bag));
    EXPECT_FALSE(typeDecomposition(variable(""), bag));
    EXPECT_TRUE(bag.empty());
    const auto word = variable(Word());
    EXPECT_FALSE(type("form_word")->composeType(new internal::ValueDataSource<PropertyBag>(bag), word));
}

TEST_F(SimplerForms, AnEnumWithoutNamesIsAnIntInItsSimplerForm) {
    const auto slot = variable(static_cast<Slot>(5));
    EXPECT_EQ(5, valueOf<int>(type("form_slot")->decomposeType(slot)));
    EXPECT_EQ("5", slot->toString());
    EXPECT_TRUE(type("form_slot")->composeType(variable(7), slot));
    EXPECT_EQ(7, static_cast<int>(slot->get()));
    EXPECT_TRUE(type("form_slot")->fromString("-2", slot));
    EXPECT_EQ(-2, static_cast<int>(slot->get()));
    for (const char* text : {"", "x", "3x", "99999999999"}) EXPECT_FALSE(type("form_slot")->fromString(text, slot));
    EXPECT_EQ(-2, static_cast<int>(slot->get()));

    const auto flags = variable(OneFlag);
    EXPECT_EQ("One", valueOf<std::string>(type("form_flags")->decomposeType(flags)));
    flags->set(static_cast<Flags>(6));
    EXPECT_EQ(6, valueOf<int>(type("form_flags")->decomposeType(flags))) << "this value has no name";
    EXPECT_TRUE(type("form_flags")->composeType(variable("6"), flags)) << "as it was written before";

    PropertyBag source, simple;
    source.ownProperty(new Property<Slot>("slot", "", static_cast<Slot>(5)));
    ASSERT_TRUE(decomposePropertyBag(source, simple));
    ASSERT_TRUE(simple.getPropertyType<int>("slot"));
    EXPECT_EQ(5, simple.getPropertyType<int>("slot")->get());
    source.getPropertyType<Slot>("slot")->set(Slot::First);
    EXPECT_TRUE(refreshProperties(source, simple));
    EXPECT_EQ(5, static_cast<int>(source.getPropertyType<Slot>("slot")->get()));
}

TEST_F(SimplerForms, ElementsBehindATextFormAreSavedAndReadBack) {
    bag.ownProperty(new Property<Joints>("p", "", Joints{{1, 2.5}}));
    for (const SaveMode mode : {SaveMode::store, SaveMode::merge, SaveMode::update})
        EXPECT_EQ((std::vector<double>{1, 2.5}), loadedOver(Joints{{7, 8, 9}}, mode).angles);
    EXPECT_THAT(get(), HasSubstr("<struct name=\"p\" type=\"form_joints\">"));
    bag.getPropertyType<Joints>("p")->set(Joints());
    EXPECT_TRUE(loadedOver(Joints{{7}}).angles.empty());
}

TEST_F(SimplerForms, EnumsWithoutNamesAreSavedAndReadBack) {
    bag.ownProperty(new Property<Slot>("p", "", static_cast<Slot>(5)));
    EXPECT_EQ(5, static_cast<int>(loadedOver(Slot::First)));
    EXPECT_THAT(get(), HasSubstr("<simple name=\"p\" type=\"long\"><value>5</value></simple>"));
    put(simple("string", "6"));
    EXPECT_TRUE(load()) << said();
    EXPECT_EQ(6, static_cast<int>(bag.getPropertyType<Slot>("p")->get())) << "as it was written before";
}

TEST_F(SimplerForms, AnEnumTakesTheNumbersOfItsEnumeratorsOnly) {
    bag.ownProperty(new Property<sample::Mode>("p", "", static_cast<sample::Mode>(3)));
    ASSERT_TRUE(saveToFile(bag, file, SaveMode::store, sink)) << said();
    EXPECT_THAT(get(), HasSubstr("<simple name=\"p\" type=\"long\"><value>3</value></simple>"));
    bag.getPropertyType<sample::Mode>("p")->set(sample::Mode::Idle);
    EXPECT_FALSE(load());
    EXPECT_THAT(said(), HasSubstr("[CPF020] property 'p' of type /sample/Mode cannot be '3'; expected 'Idle', "
                                  "'Filling', 'Draining' or 'Emptying'\n"));
    EXPECT_EQ(sample::Mode::Idle, bag.getPropertyType<sample::Mode>("p")->get());
    put(simple("string", "3"));
    EXPECT_FALSE(load());
    put(simple("long", "1"));
    EXPECT_TRUE(load()) << said();
    EXPECT_EQ(sample::Mode::Filling, bag.getPropertyType<sample::Mode>("p")->get());
    put(simple("string", "7"));
    EXPECT_TRUE(load()) << said();
    bag.getPropertyType<sample::Mode>("p")->set(sample::Mode::Draining);
    EXPECT_EQ(sample::Mode::Draining, loadedOver(sample::Mode::Idle, SaveMode::update));
    EXPECT_THAT(get(), HasSubstr("<simple name=\"p\" type=\"string\"><value>Draining</value></simple>"));
}

TEST_F(SimplerForms, AnUnknownEnumeratorIsAnsweredWithTheOthersAndTheNearest) {
    bag.ownProperty(new Property<sample::Mode>("p", ""));
    put(simple("string", "Fillign"));
    EXPECT_FALSE(load());
    EXPECT_THAT(said(), HasSubstr("property 'p' of type /sample/Mode cannot be 'Fillign'; expected 'Idle', 'Filling', "
                                  "'Draining' or 'Emptying'; did you mean 'Filling'?\n"));
    Property<sample::Tank> tank("t", "");
    bag.addProperty(tank);
    for (const char* mode : {"<simple name=\"mode\" type=\"string\"><value>Idel</value></simple>",
                             "<simple name=\"mode\" type=\"long\"><value>99</value></simple>"}) {
        put("<struct name=\"t\" type=\"/sample/Tank\">" + std::string(mode) + "</struct>");
        EXPECT_FALSE(load());
    }
    EXPECT_THAT(said(), HasSubstr("property 't.mode' of type /sample/Mode cannot be 'Idel'; expected 'Idle'"));
    EXPECT_THAT(said(), HasSubstr("property 't.mode' of type /sample/Mode cannot be '99'; expected 'Idle'"));
    bag.removeProperty(&tank);
}

TEST_F(SimplerForms, FlagsMayBeCombined) {
    bag.ownProperty(new Property<Options>("p", ""));
    put(simple("long", "5"));
    EXPECT_TRUE(load()) << said();
    EXPECT_EQ(5, static_cast<int>(bag.getPropertyType<Options>("p")->get()));
    put(simple("long", "8"));
    EXPECT_FALSE(load());
}

TEST_F(SimplerForms, TheSizeThatOldFilesPutInFrontOfElementsIsNone) {
    const std::string two = number("0", "1.5") + number("1", "2.5");
    bag.ownProperty(new Property<std::vector<double>>("p", ""));
    put(withSize("array", "2", two));
    ASSERT_TRUE(load()) << said();
    EXPECT_EQ((std::vector<double>{1.5, 2.5}), bag.getPropertyType<std::vector<double>>("p")->get());
    put(withSize("array", "0", ""));
    ASSERT_TRUE(load()) << said();
    EXPECT_TRUE(bag.getPropertyType<std::vector<double>>("p")->get().empty());
    put(withSize("array", "7", two));
    EXPECT_TRUE(load()) << "a warning, and the elements that are there";
    EXPECT_EQ((std::vector<double>{1.5, 2.5}), bag.getPropertyType<std::vector<double>>("p")->get());
    put("<struct name=\"p\" type=\"array\">" + number("Size", "1.5") + "</struct>");
    ASSERT_TRUE(load()) << said();
    EXPECT_EQ(std::vector<double>{1.5}, bag.getPropertyType<std::vector<double>>("p")->get()) << "not a whole number";
}

TEST_F(SimplerForms, TheSizeInFrontOfElementsIsNoneInSequencesOfAllKinds) {
    bag.ownProperty(new Property<Joints>("p", ""));
    put(withSize("form_joints", "1", number("0", "1.5")));
    ASSERT_TRUE(load()) << said();
    EXPECT_EQ(std::vector<double>{1.5}, bag.getPropertyType<Joints>("p")->get().angles);

    bag.clear();
    bag.ownProperty(new Property<std::set<int>>("p", ""));
    put(withSize("form_set", "2",
                 "<simple type=\"long\"><value>4</value></simple>"
                 "<simple type=\"long\"><value>3</value></simple>"));
    ASSERT_TRUE(load()) << said();
    EXPECT_EQ((std::set<int>{3, 4}), bag.getPropertyType<std::set<int>>("p")->get());

    bag.clear();
    bag.ownProperty(new Property<sample::Tank>("p", ""));
    const auto member = [](std::string text, const std::string& name) {
        return text.replace(text.find("\"p\""), 3, '"' + name + '"');
    };
    const std::string three = number("0", "1") + number("1", "2") + number("2", "3");
    put("<struct name=\"p\" type=\"/sample/Tank\">" + member(withSize("array", "3", three), "levels") +
        member(withSize("/double[]", "3", three), "weights") + "</struct>");
    ASSERT_TRUE(load()) << said();
    const sample::Tank tank = bag.getPropertyType<sample::Tank>("p")->get();
    EXPECT_EQ((std::vector<double>{1, 2, 3}), tank.levels);
    EXPECT_EQ(3, tank.weights[2]);

    put("<struct name=\"p\" type=\"/sample/Tank\">" +
        member(withSize("array", "1", "<simple name=\"0\" type=\"string\"><value>x</value></simple>"), "levels") +
        "</struct>");
    EXPECT_FALSE(load());
    EXPECT_THAT(said(), HasSubstr("property 'p.levels.0' of type double cannot take a value of type string"));
}

TEST_F(SimplerForms, TheSizeInFrontOfElementsGoesWhenAFileIsUpdated) {
    for (const SaveMode mode : {SaveMode::update, SaveMode::merge}) {
        bag.clear();
        bag.ownProperty(new Property<std::vector<double>>("p", "", {3, 4}));
        put(withSize("array", "3", number("0", "0") + number("1", "1") + number("2", "2")));
        EXPECT_EQ((std::vector<double>{3, 4}), loadedOver(std::vector<double>(), mode));
        EXPECT_THAT(get(), testing::Not(HasSubstr("Size")));
        EXPECT_THAT(get(), HasSubstr("<simple name=\"1\" type=\"double\"><value>4</value></simple></struct>"));
        put(withSize("array", "0", ""));
        EXPECT_EQ((std::vector<double>{3, 4}), loadedOver(std::vector<double>(), mode)) << get();
    }
}
