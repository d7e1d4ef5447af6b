// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OPERATORS_HPP
#define ORO_OPERATORS_HPP

#include "ErasedFunction.hpp"
#include <boost/shared_ptr.hpp>
#include <memory>
#include <string>

namespace RTT {
namespace types {

/** A unary operator on one type. */
struct UnaryOp {
    std::string op;
    ErasedFunction function;
};

/** A binary operator on a pair of types. */
struct BinaryOp {
    std::string op;
    ErasedFunction function;
};

/** An operator on three values, such as an assignment to an element. */
struct TernaryOp {
    std::string op;
    ErasedFunction function;
};

/** A part of a value that is computed from it, reached as `value.name`. */
struct DotOp {
    std::string op;
    ErasedFunction function;
};

/** One built-in operator in a constant table. */
struct OperatorRow {
    const char* op;
    TypeRef result, first, second;  ///< second: null for unary operators
    ComputeFunction call;
};

/** The operators that scripts may use on values. Thread safe; not for real-time contexts. */
class RTT_API OperatorRepository {
public:
    typedef boost::shared_ptr<OperatorRepository> shared_ptr;
    static shared_ptr Instance();
    /** For programs that end with it: nothing happens, the operators are kept until the process ends. */
    static void Release() {}
    ~OperatorRepository();

    /** Takes ownership. */
    void add(UnaryOp* op);
    void add(BinaryOp* op);
    void add(TernaryOp* op);
    void add(DotOp* op);
    /** The rows must have static storage. */
    void add(const OperatorRow* rows, std::size_t count);

    /**
     * The source of the result: the operator of exactly these types, else the first one whose first type fits and to
     * whose other types the other operands can be converted; with one operand, the first one to whose type it can be
     * converted. Null if there is none. The caller owns it.
     */
    base::DataSourceBase* applyUnary(const std::string& op, base::DataSourceBase* operand);
    base::DataSourceBase* applyBinary(const std::string& op, base::DataSourceBase* first, base::DataSourceBase* second);
    base::DataSourceBase* applyTernary(const std::string& op, base::DataSourceBase* first, base::DataSourceBase* second,
                                       base::DataSourceBase* third);
    base::DataSourceBase* applyDot(const std::string& name, base::DataSourceBase* value);

private:
    OperatorRepository();
    base::DataSourceBase* apply(const std::string& op,
                                const std::vector<base::DataSourceBase::shared_ptr>& operands) const;
    struct State;
    std::unique_ptr<State> state_;
};

RTT_API OperatorRepository::shared_ptr operators();

}  // namespace types
}  // namespace RTT

#include <rtt/types/typekit_includes.hpp>

#endif
