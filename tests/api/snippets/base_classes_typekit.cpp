// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The classes that typekits derive from.
#include <rtt/types/EnumTypeInfo.hpp>
#include <rtt/types/MemberFactory.hpp>
#include <rtt/types/PrimitiveTypeInfo.hpp>
#include <rtt/types/SequenceTypeInfo.hpp>
#include <rtt/types/StructTypeInfo.hpp>
#include <rtt/types/TemplateCompositionFactory.hpp>
#include <rtt/types/TemplateTypeInfo.hpp>
#include <rtt/types/TypeInfoGenerator.hpp>
#include <rtt/types/TypekitPlugin.hpp>
#include <rtt/types/Types.hpp>
#include <rtt/internal/DataSourceGenerator.hpp>
#include <rtt/internal/FusedFunctorDataSource.hpp>

#include <gtest/gtest.h>

namespace derived_types {

struct Wheel {
    double radius;
    int teeth;
};
struct Axle {
    double length;
};
struct Handle {
    int id;
};
enum Gear { Park, Drive };
typedef std::vector<Wheel> Wheels;

std::ostream& operator<<(std::ostream& os, const Wheel& w) { return os << w.radius << '/' << w.teeth; }
std::istream& operator>>(std::istream& is, Wheel& w) {
    char slash;
    return is >> w.radius >> slash >> w.teeth;
}

}  // namespace derived_types

namespace boost {
namespace serialization {
template <class Archive>
void serialize(Archive& a, derived_types::Axle& axle, unsigned int) {
    using boost::serialization::make_nvp;
    a& make_nvp("length", axle.length);
}
}  // namespace serialization
}  // namespace boost

namespace derived_types {

using namespace RTT;
using namespace RTT::types;
using namespace RTT::detail;

int teethOf(const Wheel& w) { return w.teeth; }

class WheelTypeInfo : public TemplateTypeInfo<Wheel, true>,
                      public MemberFactory,
                      public TemplateCompositionFactory<Wheel> {
public:
    WheelTypeInfo(std::string name) : TemplateTypeInfo<Wheel, true>(name) {}

    bool installTypeInfoObject(TypeInfo* ti) override {
        boost::shared_ptr<WheelTypeInfo> mthis = boost::dynamic_pointer_cast<WheelTypeInfo>(this->getSharedPtr());
        TemplateTypeInfo<Wheel, true>::installTypeInfoObject(ti);
        ti->setMemberFactory(mthis);
        ti->setCompositionFactory(mthis);
        return false;
    }
    TypeInfo* getTypeInfoObject() const override { return TemplateTypeInfo<Wheel, true>::getTypeInfoObject(); }
    const std::string& getTypeName() const override { return TemplateTypeInfo<Wheel, true>::getTypeName(); }

    // The factory of values.
    base::AttributeBase* buildConstant(std::string name, base::DataSourceBase::shared_ptr dsb, int) const override {
        return TemplateTypeInfo<Wheel, true>::buildConstant(name, dsb, 0);
    }
    base::AttributeBase* buildVariable(std::string name, int hint) const override {
        return TemplateTypeInfo<Wheel, true>::buildVariable(name, hint);
    }
    base::AttributeBase* buildAttribute(std::string name, base::DataSourceBase::shared_ptr in) const override {
        return TemplateTypeInfo<Wheel, true>::buildAttribute(name, in);
    }
    base::AttributeBase* buildAlias(std::string name, base::DataSourceBase::shared_ptr in) const override {
        return TemplateTypeInfo<Wheel, true>::buildAlias(name, in);
    }
    base::PropertyBase* buildProperty(const std::string& name, const std::string& desc,
                                      base::DataSourceBase::shared_ptr source = 0) const override {
        return TemplateTypeInfo<Wheel, true>::buildProperty(name, desc, source);
    }
    base::DataSourceBase::shared_ptr buildValue() const override { return TemplateTypeInfo<Wheel, true>::buildValue(); }
    base::DataSourceBase::shared_ptr buildReference(void* ptr) const override {
        return TemplateTypeInfo<Wheel, true>::buildReference(ptr);
    }
    base::DataSourceBase::shared_ptr buildActionAlias(base::ActionInterface* action,
                                                      base::DataSourceBase::shared_ptr in) const override {
        return TemplateTypeInfo<Wheel, true>::buildActionAlias(action, in);
    }

    // The factory of texts.
    std::ostream& write(std::ostream& os, base::DataSourceBase::shared_ptr in) const override {
        return TemplateTypeInfo<Wheel, true>::write(os, in);
    }
    std::istream& read(std::istream& is, base::DataSourceBase::shared_ptr out) const override {
        return TemplateTypeInfo<Wheel, true>::read(is, out);
    }
    bool isStreamable() const override { return true; }

    // The factory of members.
    std::vector<std::string> getMemberNames() const override { return std::vector<std::string>(1, "teeth"); }
    base::DataSourceBase::shared_ptr getMember(base::DataSourceBase::shared_ptr item,
                                               const std::string& name) const override {
        if (name == "teeth") return newFunctorDataSource(&teethOf, GenerateDataSource()(item.get()));
        return base::DataSourceBase::shared_ptr();
    }
    base::DataSourceBase::shared_ptr getMember(base::DataSourceBase::shared_ptr item,
                                               base::DataSourceBase::shared_ptr id) const override {
        DataSource<std::string>::shared_ptr name = DataSource<std::string>::narrow(id.get());
        return name ? getMember(item, name->get()) : base::DataSourceBase::shared_ptr();
    }
    bool resize(base::DataSourceBase::shared_ptr, int) const override { return false; }

    // The factory of bags.
    bool composeTypeImpl(const PropertyBag& source, Wheel& result) const override {
        Property<double> radius = source.getProperty("radius");
        if (!radius.ready()) return false;
        result.radius = radius.get();
        return true;
    }
    bool decomposeTypeImpl(const Wheel& source, PropertyBag& targetbag) const override {
        targetbag.setType("wheel");
        targetbag.ownProperty(new Property<double>("radius", "in m", source.radius));
        return true;
    }
};

struct AxleTypeInfo : public StructTypeInfo<Axle> {
    AxleTypeInfo() : StructTypeInfo<Axle>("axle") {}
    bool installTypeInfoObject(TypeInfo* ti) override { return StructTypeInfo<Axle>::installTypeInfoObject(ti); }
};

struct WheelsTypeInfo : public SequenceTypeInfo<Wheels> {
    WheelsTypeInfo() : SequenceTypeInfo<Wheels>("wheels") {}
};

struct HandleTypeInfo : public PrimitiveTypeInfo<Handle> {
    HandleTypeInfo() : PrimitiveTypeInfo<Handle>("handle") {}
};

struct GearTypeInfo : public EnumTypeInfo<Gear> {
    GearTypeInfo() : EnumTypeInfo<Gear>("gear") {
        to_string[Park] = "P";
        to_string[Drive] = "D";
    }
};

/** Only a name. */
class OpaqueGenerator : public TypeInfoGenerator {
    std::string name;

public:
    OpaqueGenerator() : name("opaque") {}
    const std::string& getTypeName() const override { return name; }
    TypeInfo* getTypeInfoObject() const override { return new TypeInfo(name); }
    bool installTypeInfoObject(TypeInfo*) override { return true; }
};

class VehicleTypekit : public RTT::types::TypekitPlugin {
public:
    bool loadTypes() override {
        TypeInfoRepository::shared_ptr ti = TypeInfoRepository::Instance();
        ti->addType(new WheelTypeInfo("wheel"));
        ti->addType(new WheelsTypeInfo());
        RTT::types::Types()->addType(new AxleTypeInfo());
        RTT::types::Types()->addType(new HandleTypeInfo());
        RTT::types::Types()->addType(new GearTypeInfo());
        RTT::types::Types()->addType(new OpaqueGenerator());
        return true;
    }
    bool loadConstructors() override { return true; }
    bool loadOperators() override { return true; }
    bool loadGlobals() override { return true; }
    std::string getName() override { return "vehicle"; }
};

}  // namespace derived_types

ORO_TYPEKIT_PLUGIN(derived_types::VehicleTypekit)

TEST(UserCode, DerivesATypekit) {
    using namespace derived_types;
    ASSERT_TRUE(loadRTTPlugin(0));
    EXPECT_EQ(getRTTPluginName(), "vehicle");
    EXPECT_EQ(getRTTTargetName(), OROCOS_TARGET_NAME);

    Wheel wheel = {0.5, 12};
    TypeInfo* type = TypeInfoRepository::Instance()->type("wheel");
    ASSERT_TRUE(type);
    EXPECT_EQ(type, TypeInfoRepository::Instance()->getTypeInfo<Wheel>());
    base::DataSourceBase::shared_ptr source = type->buildReference(&wheel);
    EXPECT_EQ(source->toString(), "0.5/12");
    EXPECT_TRUE(type->fromString("0.25/10", source));
    EXPECT_EQ(wheel.teeth, 10);
    EXPECT_EQ(source->getMemberNames().size(), 1u);
    DataSource<int>::shared_ptr teeth = DataSource<int>::narrow(source->getMember("teeth").get());
    ASSERT_TRUE(teeth);
    EXPECT_EQ(teeth->get(), 10);

    Property<PropertyBag> bag("bag", "", PropertyBag());
    ASSERT_TRUE(type->decomposeType(source));
    EXPECT_TRUE(bag.getDataSource()->update(type->decomposeType(source).get()));
    EXPECT_EQ(bag.rvalue().getType(), "wheel");
    Property<Wheel> copy("copy", "");
    EXPECT_TRUE(copy.compose(bag.rvalue()));
    EXPECT_EQ(copy.get().radius, 0.25);
}

TEST(UserCode, DerivesTheReadyMadeGenerators) {
    using namespace derived_types;
    ASSERT_TRUE(loadRTTPlugin(0));
    Axle axle = {1.5};
    base::DataSourceBase::shared_ptr source = Types()->type("axle")->buildReference(&axle);
    AssignableDataSource<double>::shared_ptr length =
        AssignableDataSource<double>::narrow(source->getMember("length").get());
    ASSERT_TRUE(length);
    length->set(2.5);
    EXPECT_EQ(axle.length, 2.5);

    Wheels wheels(2);
    base::DataSourceBase::shared_ptr all = Types()->type("wheels")->buildReference(&wheels);
    EXPECT_TRUE(Types()->type("wheels")->resize(all, 3));
    EXPECT_EQ(wheels.size(), 3u);

    Gear gear = Park;
    base::DataSourceBase::shared_ptr lever = Types()->type("gear")->buildReference(&gear);
    EXPECT_EQ(lever->toString(), "P");
    EXPECT_TRUE(Types()->type("gear")->fromString("D", lever));
    EXPECT_EQ(gear, Drive);

    EXPECT_TRUE(Types()->type("handle")->buildValue());
    EXPECT_EQ(Types()->type("handle")->inputPort("in"), nullptr) << "a primitive type has no ports";
    EXPECT_TRUE(Types()->type("opaque"));
    EXPECT_FALSE(Types()->type("opaque")->buildValue());
}
