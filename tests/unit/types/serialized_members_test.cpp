// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What StructTypeInfo finds in the serialization functions that people write (spec 5.2, 5.3).
#include "builtin_typekit.hpp"

#include <rtt/types/BoostArrayTypeInfo.hpp>
#include <rtt/types/PropertyDecomposition.hpp>
#include <rtt/types/StructTypeInfo.hpp>
#include <boost/serialization/access.hpp>
#include <boost/serialization/base_object.hpp>
#include <boost/serialization/split_member.hpp>

#include <array>

using namespace RTT;
using namespace RTT::types;
using namespace types_test;

namespace serialized {

/** With private members, and two functions instead of one. */
class Split {
public:
    double visible = 1;

private:
    friend class boost::serialization::access;
    template <class Archive>
    void save(Archive& a, const unsigned int) const {
        a << BOOST_SERIALIZATION_NVP(visible);
        a << BOOST_SERIALIZATION_NVP(hidden);
    }
    template <class Archive>
    void load(Archive& a, const unsigned int) {
        a >> BOOST_SERIALIZATION_NVP(visible);
        a >> BOOST_SERIALIZATION_NVP(hidden);
    }
    BOOST_SERIALIZATION_SPLIT_MEMBER()
    int hidden = 2;
};

struct Base {
    int id = 3;
    template <class Archive>
    void serialize(Archive& a, const unsigned int) {
        a& BOOST_SERIALIZATION_NVP(id);
    }
};

enum Unknown { One, Two };

struct Derived : Base {
    boost::array<float, 2> pair{};
    std::array<int, 2> numbers{};
    Unknown unregistered = Two;
    double last = 4;
    template <class Archive>
    void serialize(Archive& a, const unsigned int) {
        a& boost::serialization::make_nvp("base", boost::serialization::base_object<Base>(*this));
        a& BOOST_SERIALIZATION_NVP(pair);
        a& BOOST_SERIALIZATION_NVP(numbers);
        a& BOOST_SERIALIZATION_NVP(unregistered);
        a& BOOST_SERIALIZATION_NVP(last);
        const int computed = id + 1;
        a& boost::serialization::make_nvp("computed", computed);
    }
};
inline std::ostream& operator<<(std::ostream& os, const Derived& d) { return os << "derived " << d.last; }

}  // namespace serialized

using namespace serialized;

namespace {

class SerializedMembers : public WithBuiltinTypes {
protected:
    static void SetUpTestSuite() {
        WithBuiltinTypes::SetUpTestSuite();
        Types()->addType(new StructTypeInfo<Split>("serialized_split"));
        Types()->addType(new StructTypeInfo<Base>("serialized_base"));
        Types()->addType(new BoostArrayTypeInfo<boost::array<float, 2>>("serialized_pair"));
        Types()->addType(new BoostArrayTypeInfo<std::array<int, 2>>("serialized_numbers"));
        Types()->addType(new StructTypeInfo<Derived, true>("serialized_derived"));
    }
};

}  // namespace

TEST_F(SerializedMembers, OfTwoFunctionsTheOneThatLoads) {
    const auto split = variable(Split());
    EXPECT_EQ((std::vector<std::string>{"visible", "hidden"}), split->getMemberNames());
    EXPECT_EQ(2, valueOf<int>(split->getMember("hidden")));
    EXPECT_EQ("{visible = 1, hidden = 2}", split->toString());
}

TEST_F(SerializedMembers, ANamedBaseIsAMember) {
    const auto derived = variable(Derived());
    ASSERT_TRUE(derived->getMember("base.id")->update(variable(8).get()));
    EXPECT_EQ(8, derived->rvalue().id);
    EXPECT_EQ(nullptr, derived->getMember("computed")) << "has no place in the object";
}

TEST_F(SerializedMembers, ArraysOfFixedSizeWithATypeOfTheirOwn) {
    const auto derived = variable(Derived());
    ASSERT_TRUE(derived->getMember("pair")->getMember("1")->update(variable(1.5f).get()));
    EXPECT_EQ(1.5f, derived->rvalue().pair[1]);
    EXPECT_EQ("serialized_pair", derived->getMember("pair")->getType());
    EXPECT_EQ(2, valueOf<int>(derived->getMember("numbers.size")));
    const SourcePtr constant(new internal::ConstantDataSource<Derived>(derived->get()));
    EXPECT_EQ("{0, 1.5}", constant->getMember("pair")->toString());
}

TEST_F(SerializedMembers, MembersOutOfReachAreLeftOutOfBags) {
    const auto derived = variable(Derived());
    EXPECT_EQ(nullptr, derived->getMember("unregistered"));
    PropertyBag bag;
    ASSERT_TRUE(typeDecomposition(derived, bag));
    EXPECT_EQ(nullptr, bag.find("unregistered"));
    ASSERT_NE(nullptr, bag.find("last"));
    bag.getPropertyType<double>("last")->set(9);
    EXPECT_TRUE(type("serialized_derived")->composeType(new internal::ValueDataSource<PropertyBag>(bag), derived));
    EXPECT_EQ(9, derived->rvalue().last);
    EXPECT_EQ("derived 9", derived->toString()) << "by operator<<";
}

TEST(Views, ReferToArraysOfAllKinds) {
    boost::array<int, 3> fixed = {{1, 2, 3}};
    carray<int> view(fixed);
    ASSERT_EQ(3u, view.count());
    view[1] = 7;
    EXPECT_EQ(7, fixed[1]);
    view = std::array<int, 2>{{8, 9}};
    EXPECT_EQ(8, fixed[0]);
    EXPECT_EQ(9, fixed[1]);
    EXPECT_EQ(3, fixed[2]);
}
