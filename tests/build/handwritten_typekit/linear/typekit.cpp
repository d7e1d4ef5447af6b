// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// In the style of the typekits for linear algebra: nothing is marked override, property bags by the two …Impl functions
// alone, constructors and operators of every kind.
#include "linear.hpp"

#include <rtt/Attribute.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/Logger.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/Property.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/internal/DataSourceGenerator.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/FusedFunctorDataSource.hpp>
#include <rtt/internal/mystd.hpp>
#include <rtt/rtt-config.h>
#include <rtt/types/OperatorTypes.hpp>
#include <rtt/types/Operators.hpp>
#include <rtt/types/PropertyDecomposition.hpp>
#include <rtt/types/TemplateConstructor.hpp>
#include <rtt/types/TemplateTypeInfo.hpp>
#include <rtt/types/TypekitPlugin.hpp>
#include <rtt/types/Types.hpp>
#if (RTT_VERSION_MAJOR * 100 + RTT_VERSION_MINOR) >= 206
#include <rtt/types/MemberFactory.hpp>
#endif
#include <boost/lexical_cast.hpp>
#include <sstream>

namespace linear {

using namespace RTT;
using namespace RTT::detail;
using namespace RTT::types;
using namespace std;

double& get_item(Vector& v, int index) {
    if (index >= v.rows() || index < 0) return RTT::internal::NA<double&>::na();
    return v(index);
}
double get_item_copy(const Vector& v, int index) {
    if (index >= v.rows() || index < 0) return RTT::internal::NA<double>::na();
    return v(index);
}
int get_size(const Vector& v) { return v.rows(); }
int get_rows(const Matrix& m) { return m.rows(); }
int get_cols(const Matrix& m) { return m.cols(); }
Vector get_row(const Matrix& m, int index) {
    Vector row(index < m.rows() ? m.cols() : 0);
    for (int j = 0; j < row.rows(); ++j) row(j) = m(index, j);
    return row;
}

struct VectorTypeInfo : public types::TemplateTypeInfo<Vector, true>
#if (RTT_VERSION_MAJOR * 100 + RTT_VERSION_MINOR) >= 206
    ,
                        public MemberFactory
#endif
{
    VectorTypeInfo() : TemplateTypeInfo<Vector, true>("linear_vector") {}

    bool installTypeInfoObject(TypeInfo* ti) {
        boost::shared_ptr<VectorTypeInfo> mthis = boost::dynamic_pointer_cast<VectorTypeInfo>(this->getSharedPtr());
        assert(mthis);
        TemplateTypeInfo<Vector, true>::installTypeInfoObject(ti);
        ti->setMemberFactory(mthis);
        return false;
    }
    bool resize(base::DataSourceBase::shared_ptr arg, int size) const {
        if (!arg->isAssignable()) return false;
        RTT::internal::AssignableDataSource<Vector>::shared_ptr asarg =
            RTT::internal::AssignableDataSource<Vector>::narrow(arg.get());
        asarg->set().resize(size);
        asarg->updated();
        return true;
    }
    virtual std::vector<std::string> getMemberNames() const {
        std::vector<std::string> result;
        result.push_back("size");
        result.push_back("capacity");
        return result;
    }
    base::DataSourceBase::shared_ptr getMember(base::DataSourceBase::shared_ptr item, const std::string& name) const {
        if (name == "size" || name == "capacity")
            return newFunctorDataSource(&get_size, GenerateDataSource()(item.get()));
        int indx = -1;
        try {
            indx = boost::lexical_cast<int>(name);
        } catch (const boost::bad_lexical_cast&) {
            log(Error) << "VectorTypeInfo: no such member: " << name << endlog();
            return base::DataSourceBase::shared_ptr();
        }
        DataSource<int>::shared_ptr id_indx = new ConstantDataSource<int>(indx);
        return newFunctorDataSource(&get_item, GenerateDataSource()(item.get(), id_indx.get()));
    }
    base::DataSourceBase::shared_ptr getMember(base::DataSourceBase::shared_ptr item,
                                               base::DataSourceBase::shared_ptr id) const {
        DataSource<int>::shared_ptr id_indx = DataSource<int>::narrow(id.get());
        DataSource<string>::shared_ptr id_name = DataSource<string>::narrow(id.get());
        if (id_name) return getMember(item, id_name->get());
        if (id_indx) {
            if (item->isAssignable())
                return newFunctorDataSource(&get_item, GenerateDataSource()(item.get(), id_indx.get()));
            return newFunctorDataSource(&get_item_copy, GenerateDataSource()(item.get(), id_indx.get()));
        }
        log(Error) << "VectorTypeInfo: not a member: " << id->getType() << endlog();
        return base::DataSourceBase::shared_ptr();
    }
    virtual bool decomposeTypeImpl(const Vector& vec, PropertyBag& targetbag) const {
        targetbag.setType("linear_vector");
        for (int i = 0; i < vec.rows(); i++) {
            std::stringstream out;
            out << i + 1;
            targetbag.add(new Property<double>(out.str(), out.str() + "th element of vector", vec(i)));
        }
        return true;
    }
    virtual bool composeTypeImpl(const PropertyBag& bag, Vector& result) const {
        if (bag.getType() != "linear_vector") {
            log(Error) << "cannot compose linear_vector from " << bag.getType() << endlog();
            return false;
        }
        result.resize(static_cast<int>(bag.size()));
        for (int i = 0; i < result.rows(); i++) {
            Property<double> elem = bag.getItem(i);
            if (!elem.ready()) return false;
            result(i) = elem.get();
        }
        return true;
    }
};

struct MatrixTypeInfo : public types::TemplateTypeInfo<Matrix, true>, public MemberFactory {
    MatrixTypeInfo() : TemplateTypeInfo<Matrix, true>("linear_matrix") {}

    bool installTypeInfoObject(TypeInfo* ti) {
        boost::shared_ptr<MatrixTypeInfo> mthis = boost::dynamic_pointer_cast<MatrixTypeInfo>(this->getSharedPtr());
        TemplateTypeInfo<Matrix, true>::installTypeInfoObject(ti);
        ti->setMemberFactory(mthis);
        return false;
    }
    virtual std::vector<std::string> getMemberNames() const { return std::vector<std::string>{"rows", "cols"}; }
    base::DataSourceBase::shared_ptr getMember(base::DataSourceBase::shared_ptr item, const std::string& name) const {
        if (name == "rows") return newFunctorDataSource(&get_rows, GenerateDataSource()(item.get()));
        if (name == "cols") return newFunctorDataSource(&get_cols, GenerateDataSource()(item.get()));
        return base::DataSourceBase::shared_ptr();
    }
    base::DataSourceBase::shared_ptr getMember(base::DataSourceBase::shared_ptr item,
                                               base::DataSourceBase::shared_ptr id) const {
        DataSource<std::string>::shared_ptr name = DataSource<std::string>::narrow(id.get());
        if (name) return getMember(item, name->get());
        return newFunctorDataSource(&get_row, GenerateDataSource()(item.get(), id.get()));
    }
    virtual bool decomposeTypeImpl(const Matrix& mat, PropertyBag& targetbag) const {
        targetbag.setType("linear_matrix");
        for (int i = 0; i < mat.rows(); i++) {
            Property<PropertyBag>* row_bag =
                new Property<PropertyBag>(boost::lexical_cast<std::string>(i + 1), "a row");
            Property<Vector> row("row", "", get_row(mat, i));
            if (!types::propertyDecomposition(&row, row_bag->value())) return false;
            row_bag->value().setType("linear_vector");
            targetbag.add(row_bag);
        }
        return true;
    }
    virtual bool composeTypeImpl(const PropertyBag& bag, Matrix& result) const {
        if (bag.getType() != "linear_matrix") return false;
        for (unsigned int i = 0; i < bag.size(); i++) {
            Property<PropertyBag> row_bag = bag.getItem(i);
            if (!row_bag.ready()) return false;
            Property<Vector> row_p(row_bag.getName(), row_bag.getDescription());
            if (!row_p.compose(row_bag)) return false;
            if (i == 0) result.resize(static_cast<int>(bag.size()), row_p.rvalue().rows());
            if (row_p.rvalue().rows() != result.cols()) return false;
            for (int j = 0; j < result.cols(); j++) result(i, j) = row_p.get()(j);
        }
        return true;
    }
};

struct vector_index_value_constructor : public std::binary_function<int, double, const Vector&> {
    typedef const Vector&(Signature)(int, double);
    mutable boost::shared_ptr<Vector> ptr;
    vector_index_value_constructor() : ptr(new Vector()) {}
    const Vector& operator()(int size, double value) const {
        ptr->resize(size);
        ptr->setConstant(value);
        return *ptr;
    }
};
struct vector_array_constructor : public std::unary_function<std::vector<double>, const Vector&> {
    typedef const Vector&(Signature)(std::vector<double>);
    mutable boost::shared_ptr<Vector> ptr;
    vector_array_constructor() : ptr(new Vector()) {}
    const Vector& operator()(std::vector<double> values) const {
        ptr->resize(static_cast<int>(values.size()));
        for (unsigned int i = 0; i < values.size(); ++i) (*ptr)(i) = values[i];
        return *ptr;
    }
};
struct matrix_constructor : public std::binary_function<int, int, Matrix> {
    typedef Matrix(Signature)(int, int);
    Matrix operator()(int rows, int cols) const { return Matrix(rows, cols); }
};
struct matrix_set : public std::ternary_function<Matrix, int, double, Matrix> {
    Matrix operator()(Matrix m, int place, double value) const {
        m(place / m.cols(), place % m.cols()) = value;
        return m;
    }
};
Matrix matrix_of(double a, double b, double c, double d) {
    Matrix m(2, 2);
    m(0, 0) = a, m(0, 1) = b, m(1, 0) = c, m(1, 1) = d;
    return m;
}

struct LinearTypekit : public types::TypekitPlugin {
    virtual std::string getName() { return "Linear"; }
    virtual bool loadTypes() {
        RTT::types::TypeInfoRepository::Instance()->addType(new VectorTypeInfo());
        RTT::types::TypeInfoRepository::Instance()->addType(new MatrixTypeInfo());
        return true;
    }
    virtual bool loadConstructors() {
        RTT::types::Types()
            ->type("linear_vector")
            ->addConstructor(types::newConstructor(vector_index_value_constructor()));
        RTT::types::Types()
            ->type("linear_vector")
            ->addConstructor(types::newConstructor(vector_array_constructor(), true));
        RTT::types::Types()->type("linear_matrix")->addConstructor(types::newConstructor(matrix_constructor()));
        RTT::types::Types()->type("linear_matrix")->addConstructor(types::newConstructor(matrix_set()));
        RTT::types::Types()->type("linear_matrix")->addConstructor(types::newConstructor(&matrix_of, false));
        RTT::types::Types()->type("string")->addConstructor(
            types::newConstructor(boost::lexical_cast<std::string, double>, false));
        return true;
    }
    virtual bool loadOperators() {
        OperatorRepository::shared_ptr oreg = OperatorRepository::Instance();
        oreg->add(newUnaryOperator("-", std::negate<Vector>()));
        oreg->add(newBinaryOperator("+", std::plus<Vector>()));
        oreg->add(newBinaryOperator("*", multiplies3<Vector, Vector, double>()));
        oreg->add(newBinaryOperator("*", multiplies3<Vector, double, Vector>()));
        oreg->add(newBinaryOperator("*", multiplies3<Vector, Matrix, Vector>()));
        oreg->add(newBinaryOperator("/", divides3<Vector, Vector, double>()));
        oreg->add(newBinaryOperator("*", std::ptr_fun(&dot)));
        return true;
    }
};

}  // namespace linear

ORO_TYPEKIT_PLUGIN(linear::LinearTypekit)

template class RTT::internal::DataSource<linear::Vector>;
template class RTT::internal::AssignableDataSource<linear::Vector>;
template class RTT::internal::AssignCommand<linear::Vector>;
template class RTT::internal::ValueDataSource<linear::Vector>;
template class RTT::internal::ConstantDataSource<linear::Vector>;
template class RTT::internal::ReferenceDataSource<linear::Vector>;
template class RTT::OutputPort<linear::Vector>;
template class RTT::InputPort<linear::Vector>;
template class RTT::Property<linear::Vector>;
template class RTT::Attribute<linear::Vector>;
