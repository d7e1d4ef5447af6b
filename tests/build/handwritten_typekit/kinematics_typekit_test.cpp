// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A typekit for kinematics is loaded unchanged: structs by boost::serialization, an enum, sequences, bags of its own.
#include "kinematics/kinematics.hpp"
#include "loaded_typekit.hpp"

#include <rtt/types/GlobalsRepository.hpp>
#include <rtt/types/PropertyDecomposition.hpp>

using namespace RTT;
using namespace types_test;
using namespace kinematics;

namespace {

class KinematicsTypekit : public WithLoadedTypekit {
protected:
    static SourcePtr vec(double x, double y, double z) { return variable(Vec(x, y, z)); }
};

Segment elbow() {
    Segment segment;
    segment.name = "elbow";
    segment.id = 4;
    segment.tip.p = Vec(1, 0, 0.5);
    segment.tip.M = Rot(0, -1, 0, 1, 0, 0, 0, 0, 1);
    segment.joint = RotZ;
    segment.limits[1] = 1.5;
    segment.inertia[1][2] = 0.125;
    segment.tags.push_back("left");
    return segment;
}

}  // namespace

TEST_F(KinematicsTypekit, Constructors) {
    EXPECT_EQ("[1,2,3]", textOf(make("KDL.Vector", {variable(1.0), variable(2.0), variable(3.0)})));
    EXPECT_EQ("[1,2,3]", textOf(make("KDL.Vector", {variable(1), variable(2), variable(3)})));
    std::vector<SourcePtr> nine;
    for (int i = 0; i < 9; ++i) nine.push_back(variable(i * 1.0));
    const SourcePtr rotation = make("KDL.Rotation", nine);
    ASSERT_TRUE(rotation);
    EXPECT_EQ(5, valueOf<Rot>(rotation).data[5]);
    const SourcePtr frame = make("KDL.Frame", {rotation, vec(1, 0, 0)});
    EXPECT_EQ(1, valueOf<Frame>(frame).p.x());
    EXPECT_EQ(nullptr, make("KDL.Frame", {rotation}));
}

TEST_F(KinematicsTypekit, Operators) {
    EXPECT_EQ("[5,7,9]", textOf(binary("+", vec(1, 2, 3), vec(4, 5, 6))));
    EXPECT_EQ("[2,4,6]", textOf(binary("*", vec(1, 2, 3), variable(2.0))));
    EXPECT_EQ("[1,1,0.5]", textOf(binary("*", variable(elbow().tip), vec(1, 0, 0))));
    EXPECT_TRUE(valueOf<bool>(binary("==", vec(1, 2, 3), vec(1, 2, 3))));
    EXPECT_EQ(-1, valueOf<Rot>(unary("inv", variable(elbow().tip.M))).data[3]);
    EXPECT_EQ(-1, valueOf<Rot>(variable(elbow().tip.M)->getMember("inverse")).data[3]) << "a dot operator";
}

TEST_F(KinematicsTypekit, MembersOfVectors) {
    const auto v = variable(Vec(1, 2, 3));
    ASSERT_TRUE(v->getMember("Y")->update(variable(7.5).get()));
    EXPECT_EQ("[1,7.5,3]", textOf(v));
    EXPECT_EQ(3, valueOf<double>(v->getMember(variable(2))));
    const SourcePtr constant(new internal::ConstantDataSource<Vec>(v->get()));
    EXPECT_EQ(7.5, valueOf<double>(constant->getMember("Y")));
    EXPECT_EQ(nullptr, v->getMember("W"));
}

TEST_F(KinematicsTypekit, MembersOfStructs) {
    const auto segment = variable(elbow());
    EXPECT_EQ((std::vector<std::string>{"name", "n.id", "tip", "joint", "limits", "inertia", "tags"}),
              segment->getMemberNames())
        << "those of the base class are those of the object";
    EXPECT_EQ("elbow", valueOf<std::string>(segment->getMember("name")));
    ASSERT_TRUE(segment->getMember("tip.p.Z")->update(variable(9.0).get()));
    EXPECT_EQ(9, segment->rvalue().tip.p.z());
    ASSERT_TRUE(segment->getMember("limits")->getMember(variable(0))->update(variable(-2.0).get()));
    EXPECT_EQ(-2, segment->rvalue().limits[0]) << "a boost::array is seen through the type of arrays";
    EXPECT_EQ(9, valueOf<int>(segment->getMember("inertia.size"))) << "two dimensions in a row";
    EXPECT_EQ(0.125, valueOf<double>(segment->getMember("inertia")->getMember(variable(5))));
    EXPECT_EQ("RotZ", textOf(segment->getMember("joint")));
    EXPECT_EQ("left", valueOf<std::string>(segment->getMember("tags")->getMember(variable(0))));
}

TEST_F(KinematicsTypekit, BagsOfItsOwn) {
    PropertyBag bag;
    ASSERT_TRUE(types::typeDecomposition(vec(1, 2, 3), bag));
    EXPECT_EQ("KDL.Vector", bag.getType());
    EXPECT_NE(nullptr, bag.find("Z"));
    Property<Vec> property("v", "");
    EXPECT_TRUE(property.compose(bag));
    EXPECT_EQ(Vec(1, 2, 3), property.rvalue());
    PropertyBag rotation;
    ASSERT_TRUE(types::typeDecomposition(variable(Rot()), rotation));
    EXPECT_NE(nullptr, rotation.find("X_x")) << "a derived generator of structs overrides its bag";
}

TEST_F(KinematicsTypekit, FileRoundTrip) {
    EXPECT_EQ(Vec(0.1, 2, -3), throughFile(Vec(0.1, 2, -3)));
    Chain chain(2, elbow());
    chain[0].joint = TransZ;
    const Chain read = throughFile(chain);
    ASSERT_EQ(2u, read.size());
    EXPECT_EQ(TransZ, read[0].joint);
    EXPECT_EQ("elbow", read[1].name);
    EXPECT_EQ(4, read[1].id);
    EXPECT_EQ(Vec(1, 0, 0.5), read[1].tip.p);
    EXPECT_EQ(-1, read[1].tip.M.data[1]);
    EXPECT_EQ(1.5, read[1].limits[1]);
    EXPECT_EQ(0.125, read[1].inertia[1][2]);
    EXPECT_EQ(std::vector<std::string>{"left"}, read[1].tags);
}

TEST_F(KinematicsTypekit, EnumsConvertAndCompose) {
    EXPECT_EQ("TransZ", textOf(type("KDL.JointType")->convert(variable(2))));
    EXPECT_EQ(1, valueOf<int>(type("int")->convert(variable(RotZ))));
    const auto joint = variable(Fixed);
    EXPECT_TRUE(type("KDL.JointType")->composeType(variable("RotZ"), joint));
    EXPECT_EQ(RotZ, joint->get());
    EXPECT_FALSE(type("KDL.JointType")->composeType(variable("Spherical"), joint));
}

TEST_F(KinematicsTypekit, Globals) {
    const auto* origin = types::GlobalsRepository::Instance()->getAttribute("KDL_ORIGIN");
    ASSERT_TRUE(origin);
    EXPECT_EQ("[0,0,0]", textOf(origin->getDataSource()));
}

TEST_F(KinematicsTypekit, TextIsRead) {
    const auto v = variable(Vec());
    EXPECT_TRUE(type("KDL.Vector")->fromString("[1,2,3]", v));
    EXPECT_EQ(Vec(1, 2, 3), v->get());
}
