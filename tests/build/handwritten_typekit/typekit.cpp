// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A typekit as users have written them by hand for years: TemplateTypeInfo with a MemberFactory mixed in, composition,
// constructors, operators, StructTypeInfo over boost.serialization, explicit instantiations.
#include "vector_types.hpp"

#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/Property.hpp>
#include <rtt/Attribute.hpp>
#include <rtt/internal/DataSourceGenerator.hpp>
#include <rtt/internal/FusedFunctorDataSource.hpp>
#include <rtt/internal/mystd.hpp>
#include <rtt/rtt-config.h>
#include <rtt/types/CArrayTypeInfo.hpp>
#include <rtt/types/OperatorTypes.hpp>
#include <rtt/types/Operators.hpp>
#include <rtt/types/PropertyComposition.hpp>
#include <rtt/types/PropertyDecomposition.hpp>
#include <rtt/types/SequenceTypeInfo.hpp>
#include <rtt/types/StructTypeInfo.hpp>
#include <rtt/types/TemplateCompositionFactory.hpp>
#include <rtt/types/TemplateConstructor.hpp>
#include <rtt/types/TemplateTypeInfo.hpp>
#include <rtt/types/TypekitPlugin.hpp>
#include <rtt/types/Types.hpp>

#if (RTT_VERSION_MAJOR * 100 + RTT_VERSION_MINOR) < 206
#error "this typekit is written for the factories of RTT 2.6 and later"
#endif

namespace algebra {

using namespace RTT;
using namespace RTT::types;

double& getItem(Vector& v, int index) {
    static double outside;
    if (index >= v.size() || index < 0) return outside;
    return v(index);
}

int getSize(const Vector& v) { return v.size(); }

struct VectorTypeInfo : public types::TemplateTypeInfo<Vector, true>,
                        public types::MemberFactory,
                        public types::TemplateCompositionFactory<Vector> {
    VectorTypeInfo() : TemplateTypeInfo<Vector, true>("algebra_vector") {}

    bool installTypeInfoObject(TypeInfo* ti) override {
        // The typical sequence of such typekits.
        boost::shared_ptr<VectorTypeInfo> mthis = boost::dynamic_pointer_cast<VectorTypeInfo>(this->getSharedPtr());
        TemplateTypeInfo<Vector, true>::installTypeInfoObject(ti);
        ti->setMemberFactory(mthis);
        ti->setCompositionFactory(mthis);
        return false;
    }

    bool resize(base::DataSourceBase::shared_ptr arg, int size) const override {
        internal::AssignableDataSource<Vector>::shared_ptr asarg =
            internal::AssignableDataSource<Vector>::narrow(arg.get());
        if (!asarg) return false;
        asarg->set().resize(size);
        asarg->updated();
        return true;
    }
    std::vector<std::string> getMemberNames() const override { return {"size", "capacity"}; }
    base::DataSourceBase::shared_ptr getMember(base::DataSourceBase::shared_ptr item,
                                               const std::string& name) const override {
        if (name == "size" || name == "capacity")
            return internal::newFunctorDataSource(&getSize, internal::GenerateDataSource()(item.get()));
        return base::DataSourceBase::shared_ptr();
    }
    base::DataSourceBase::shared_ptr getMember(base::DataSourceBase::shared_ptr item,
                                               base::DataSourceBase::shared_ptr id) const override {
        internal::DataSource<std::string>::shared_ptr id_name = internal::DataSource<std::string>::narrow(id.get());
        if (id_name) return getMember(item, id_name->get());
        internal::DataSource<int>::shared_ptr id_indx =
            internal::DataSource<int>::narrow(internal::DataSourceTypeInfo<int>::getTypeInfo()->convert(id).get());
        if (id_indx)
            return internal::newFunctorDataSource(&getItem, internal::GenerateDataSource()(item.get(), id_indx.get()));
        return base::DataSourceBase::shared_ptr();
    }

    bool decomposeTypeImpl(const Vector& vec, PropertyBag& targetbag) const override {
        targetbag.setType("algebra_vector");
        for (int i = 0; i != vec.size(); i++)
            targetbag.ownProperty(new Property<double>("Element" + std::to_string(i), "", vec(i)));
        return true;
    }
    bool composeTypeImpl(const PropertyBag& bag, Vector& result) const override {
        result.resize(static_cast<int>(bag.size()));
        int i = 0;
        for (PropertyBag::const_iterator it = bag.begin(); it != bag.end(); ++it) {
            Property<double> element = *it;
            if (!element.ready()) return false;
            result(i++) = element.get();
        }
        return true;
    }
};

// The constructors, in the three styles that there are.
struct vector_index_value_constructor {
    typedef Vector(Signature)(int, double);
    Vector operator()(int size, double value) const {
        Vector v(size);
        for (int i = 0; i != size; ++i) v(i) = value;
        return v;
    }
};
Vector vectorOfSize(int size) { return Vector(size); }
struct vector_from_array : public std::ternary_function<double, double, double, Vector> {
    Vector operator()(double a, double b, double c) const {
        Vector v(3);
        v(0) = a, v(1) = b, v(2) = c;
        return v;
    }
};

class AlgebraTypekit : public types::TypekitPlugin {
public:
    bool loadTypes() override {
        RTT::types::Types()->addType(new VectorTypeInfo());
        RTT::types::Types()->addType(new StructTypeInfo<Joint>("algebra_joint"));
        RTT::types::Types()->addType(new SequenceTypeInfo<std::vector<Joint>>("algebra_joints"));
        RTT::types::Types()->addType(new CArrayTypeInfo<carray<double>>("algebra_doubles"));
        return true;
    }
    bool loadConstructors() override {
        RTT::types::Types()
            ->type("algebra_vector")
            ->addConstructor(types::newConstructor(vector_index_value_constructor()));
        RTT::types::Types()->type("algebra_vector")->addConstructor(types::newConstructor(&vectorOfSize, false));
        RTT::types::Types()->type("algebra_vector")->addConstructor(types::newConstructor(vector_from_array()));
        return true;
    }
    bool loadOperators() override {
        RTT::types::operators()->add(newBinaryOperator("+", std::plus<Vector>()));
        RTT::types::operators()->add(newUnaryOperator("norm1", [](const Vector& v) {
            double sum = 0;
            for (int i = 0; i != v.size(); ++i) sum += v(i) < 0 ? -v(i) : v(i);
            return sum;
        }));
        return true;
    }
    std::string getName() override { return "algebra-typekit"; }
};

}  // namespace algebra

ORO_TYPEKIT_PLUGIN(algebra::AlgebraTypekit)

#define INSTANTIATE(TYPE)                                     \
    template struct RTT::internal::DataSourceTypeInfo<TYPE>;  \
    template class RTT::internal::DataSource<TYPE>;           \
    template class RTT::internal::AssignableDataSource<TYPE>; \
    template class RTT::internal::AssignCommand<TYPE>;        \
    template class RTT::internal::ValueDataSource<TYPE>;      \
    template class RTT::internal::ConstantDataSource<TYPE>;   \
    template class RTT::internal::ReferenceDataSource<TYPE>;  \
    template class RTT::base::ChannelElement<TYPE>;           \
    template class RTT::OutputPort<TYPE>;                     \
    template class RTT::InputPort<TYPE>;                      \
    template class RTT::Property<TYPE>;                       \
    template class RTT::Attribute<TYPE>;                      \
    template class RTT::Constant<TYPE>;

INSTANTIATE(algebra::Vector)
INSTANTIATE(algebra::Joint)
