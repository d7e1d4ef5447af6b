// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In the style of the typekits for kinematics: one class template for all fixed vectors with its own bags, structs by
// boost::serialization, an enum, sequences, arrays, global constants.
#include "types.hpp"

#include <rtt/Logger.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/base/PropertyIntrospection.hpp>
#include <rtt/internal/DataSourceGenerator.hpp>
#include <rtt/internal/FusedFunctorDataSource.hpp>
#include <rtt/types/CArrayTypeInfo.hpp>
#include <rtt/types/EnumTypeInfo.hpp>
#include <rtt/types/GlobalsRepository.hpp>
#include <rtt/types/OperatorTypes.hpp>
#include <rtt/types/Operators.hpp>
#include <rtt/types/SequenceTypeInfo.hpp>
#include <rtt/types/StructTypeInfo.hpp>
#include <rtt/types/TemplateConstructor.hpp>
#include <rtt/types/TemplateTypeInfo.hpp>
#include <rtt/types/TypekitPlugin.hpp>

namespace kinematics {

using namespace RTT;
using namespace RTT::detail;

/** Collects the numbers of a bag, whatever their types. */
class NumberCollector : public base::PropertyIntrospection {
public:
    std::vector<double> numbers;
    bool valid;
    NumberCollector() : valid(true) {}
    void introspect(base::PropertyBase* p) {
        Property<float> other(p);
        valid = false;
    }
    void introspect(Property<bool>&) { valid = false; }
    void introspect(Property<char>&) { valid = false; }
    void introspect(Property<int>& p) { numbers.push_back(p.get()); }
    void introspect(Property<unsigned int>& p) { numbers.push_back(p.get()); }
    void introspect(Property<double>& p) { numbers.push_back(p.get()); }
    void introspect(Property<float>& p) { numbers.push_back(p.get()); }
    void introspect(Property<std::string>&) { valid = false; }
    void introspect(Property<PropertyBag>&) { valid = false; }
};

void decomposeProperty(const Vec& v, PropertyBag& targetbag) {
    targetbag.setType("KDL.Vector");
    targetbag.add(new Property<double>("X", "X Value", v.x()));
    targetbag.add(new Property<double>("Y", "Y Value", v.y()));
    targetbag.add(new Property<double>("Z", "Z Value", v.z()));
}
bool composeProperty(const PropertyBag& bag, Vec& v) {
    if (bag.getType() != std::string("KDL.Vector")) return false;
    NumberCollector collector;
    const_cast<PropertyBag&>(bag).identify(&collector);
    if (!collector.valid || collector.numbers.size() != 3) return false;
    v = Vec(collector.numbers[0], collector.numbers[1], collector.numbers[2]);
    return true;
}

template <class KDLType>
double& getReference(KDLType& kdl, int index) {
    return kdl(index);
}
template <class KDLType>
double getValue(const KDLType& kdl, int index) {
    return kdl(index);
}

template <class KDLType, int size>
class KDLVectorTypeInfo : public types::TemplateTypeInfo<KDLType, true>, public types::MemberFactory {
public:
    KDLVectorTypeInfo(std::string name) : types::TemplateTypeInfo<KDLType, true>(name) {}
    virtual ~KDLVectorTypeInfo() {}

    bool installTypeInfoObject(types::TypeInfo* ti) {
        boost::shared_ptr<KDLVectorTypeInfo<KDLType, size>> mthis =
            boost::dynamic_pointer_cast<KDLVectorTypeInfo<KDLType, size>>(this->getSharedPtr());
        types::TemplateTypeInfo<KDLType, true>::installTypeInfoObject(ti);
        ti->setMemberFactory(mthis);
        // As some typekits do, though there is nothing left to install.
        ti->setCompositionFactory(mthis);
        return false;
    }
    virtual bool decomposeTypeImpl(const KDLType& source, PropertyBag& targetbag) const {
        decomposeProperty(source, targetbag);
        return true;
    }
    virtual bool composeTypeImpl(const PropertyBag& bag, KDLType& result) const { return composeProperty(bag, result); }
    virtual std::vector<std::string> getMemberNames() const {
        const char* names[] = {"X", "Y", "Z"};
        return std::vector<std::string>(names, names + size);
    }
    virtual base::DataSourceBase::shared_ptr getMember(base::DataSourceBase::shared_ptr item,
                                                       const std::string& name) const {
        const std::vector<std::string> names = getMemberNames();
        for (int i = 0; i < size; i++)
            if (names[i] == name) return getMember(item, new ConstantDataSource<int>(i));
        return base::DataSourceBase::shared_ptr();
    }
    virtual base::DataSourceBase::shared_ptr getMember(base::DataSourceBase::shared_ptr item,
                                                       base::DataSourceBase::shared_ptr id) const {
        DataSource<std::string>::shared_ptr id_name = DataSource<std::string>::narrow(id.get());
        if (id_name) return getMember(item, id_name->get());
        typename AssignableDataSource<KDLType>::shared_ptr adata =
            boost::dynamic_pointer_cast<AssignableDataSource<KDLType>>(item);
        if (adata && adata->isAssignable())
            return newFunctorDataSource(&getReference<KDLType>, GenerateDataSource()(item.get(), id.get()));
        return newFunctorDataSource(&getValue<KDLType>, GenerateDataSource()(item.get(), id.get()));
    }
};

struct JointTypeInfo : public types::EnumTypeInfo<JointType> {
    JointTypeInfo() : types::EnumTypeInfo<JointType>("KDL.JointType") {
        to_string[Fixed] = "Fixed";
        to_string[RotZ] = "RotZ";
        to_string[TransZ] = "TransZ";
    }
};

/** A struct that keeps its orientation as nine named numbers in files. */
struct RotTypeInfo : public types::StructTypeInfo<Rot> {
    RotTypeInfo() : types::StructTypeInfo<Rot>("KDL.Rotation") {}
    virtual bool decomposeTypeImpl(const Rot& r, PropertyBag& bag) const {
        const char* names[] = {"X_x", "Y_x", "Z_x", "X_y", "Y_y", "Z_y", "X_z", "Y_z", "Z_z"};
        bag.setType("KDL.Rotation");
        for (int i = 0; i < 9; i++) bag.ownProperty(new Property<double>(names[i], "", r.data[i]));
        return true;
    }
    virtual bool composeTypeImpl(const PropertyBag& bag, Rot& r) const {
        NumberCollector collector;
        const_cast<PropertyBag&>(bag).identify(&collector);
        if (!collector.valid || collector.numbers.size() != 9) return false;
        for (int i = 0; i < 9; i++) r.data[i] = collector.numbers[i];
        return true;
    }
};

Vec vectorxyz(double x, double y, double z) { return Vec(x, y, z); }
Rot rotation(double a, double b, double c, double d, double e, double f, double g, double h, double i) {
    return Rot(a, b, c, d, e, f, g, h, i);
}
Frame framerv(const Rot& r, const Vec& v) { return Frame(r, v); }
Rot inverse(const Rot& r) { return r.Inverse(); }

class KDLTypekitPlugin : public types::TypekitPlugin {
public:
    virtual std::string getName() { return "KDL"; }
    virtual bool loadTypes() {
        types::TypeInfoRepository::shared_ptr ti = types::TypeInfoRepository::Instance();
        ti->addType(new KDLVectorTypeInfo<Vec, 3>("KDL.Vector"));
        ti->addType(new RotTypeInfo());
        ti->addType(new types::StructTypeInfo<Frame>("KDL.Frame"));
        ti->addType(new JointTypeInfo());
        ti->addType(new types::StructTypeInfo<Segment>("KDL.Segment"));
        ti->addType(new types::SequenceTypeInfo<Chain>("KDL.Chain"));
        ti->addType(new types::SequenceTypeInfo<std::vector<std::string>>("strings"));
        ti->addType(new types::CArrayTypeInfo<types::carray<double>>("doubles"));
        return true;
    }
    virtual bool loadConstructors() {
        types::Types()->type("KDL.Vector")->addConstructor(types::newConstructor(&vectorxyz));
        types::Types()->type("KDL.Rotation")->addConstructor(types::newConstructor(&rotation));
        types::Types()->type("KDL.Frame")->addConstructor(types::newConstructor(&framerv));
        return true;
    }
    virtual bool loadOperators() {
        types::OperatorRepository::shared_ptr oreg = types::operators();
        oreg->add(types::newBinaryOperator("==", std::equal_to<Vec>()));
        oreg->add(types::newBinaryOperator("+", std::plus<Vec>()));
        oreg->add(types::newBinaryOperator("*", multiplies3<Vec, Vec, double>()));
        oreg->add(types::newBinaryOperator("*", multiplies3<Vec, Frame, Vec>()));
        oreg->add(types::newUnaryOperator("inv", &inverse));
        oreg->add(types::newDotOperator("inverse", &inverse));
        return true;
    }
    virtual bool loadGlobals() {
        types::GlobalsRepository::Instance()->setValue(new Constant<Vec>("KDL_ORIGIN", Vec()));
        return true;
    }
};

}  // namespace kinematics

ORO_TYPEKIT_PLUGIN(kinematics::KDLTypekitPlugin)

#define KINEMATICS_TEMPLATES(T)                            \
    template class RTT::internal::DataSource<T>;           \
    template class RTT::internal::AssignableDataSource<T>; \
    template class RTT::internal::AssignCommand<T>;        \
    template class RTT::internal::ValueDataSource<T>;      \
    template class RTT::internal::ConstantDataSource<T>;   \
    template class RTT::internal::ReferenceDataSource<T>;  \
    template class RTT::OutputPort<T>;                     \
    template class RTT::InputPort<T>;                      \
    template class RTT::Property<T>;                       \
    template class RTT::Attribute<T>;

KINEMATICS_TEMPLATES(kinematics::Vec)
KINEMATICS_TEMPLATES(kinematics::Frame)
KINEMATICS_TEMPLATES(kinematics::Segment)
