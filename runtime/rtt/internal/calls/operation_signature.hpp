// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The signature of an operation, for users that learn it at run time.
#ifndef ORO_INTERNAL_OPERATION_SIGNATURE_HPP
#define ORO_INTERNAL_OPERATION_SIGNATURE_HPP

#include <rtt/OperationInterfacePart.hpp>

#include <string>
#include <typeinfo>
#include <vector>

namespace RTT {
namespace internal {

/** What an operation takes and gives. */
struct RTT_API OperationSignature {
    struct RTT_API Value {
        // Without reference and const:
        const types::TypeInfo* type = nullptr;  ///< null: in no typekit
        const std::type_info* id = nullptr;     ///< null: known by its name only
        std::string typeName;                   ///< "void" for no result
        bool isConst = false, isReference = false, isPointer = false;
        std::string name, description;  ///< of an argument

        /** An argument that the operation assigns to. */
        bool isOutput() const { return isReference && !isConst; }
        bool isVoid() const { return typeName == "void"; }
        /** "double const&" */
        std::string text() const;
        /** The same without reference and const. */
        std::string plainText() const { return typeName + (isPointer ? "*" : ""); }
        // For the argument that has that index, counted from 1. They throw one of the FactoryExceptions.
        /** `source` itself, or a source that converts its value to this type. */
        base::DataSourceBase::shared_ptr sourceFor(base::DataSourceBase::shared_ptr source, std::size_t index) const;
        /** Checks that values of this type can be assigned to `to`. */
        void checkAssigned(const base::DataSourceBase::shared_ptr& to, std::size_t index) const;
        bool isTypeOf(const base::DataSourceBase& source) const;
        [[noreturn]] void throwWrongType(const base::DataSourceBase::shared_ptr& found, std::size_t index) const;
        /** From such a text, or from "const double&"; the type is not looked up. */
        static Value parsed(const std::string& text);
    };

    Value result;
    std::vector<Value> arguments;

    /** What collecting a sent call gives: the result, unless that is void, and the arguments that are assigned. */
    std::vector<const Value*> collected() const;
};

/** An operation that has a signature, from which the rest follows. */
class RTT_API SignedPart : public OperationInterfacePart {
public:
    OperationSignature signature() const override = 0;

    std::vector<ArgumentDescription> getArgumentList() const final;
    std::string resultType() const final;
    unsigned arity() const final;
    const types::TypeInfo* getArgumentType(unsigned index) const final;
    unsigned collectArity() const final;
    const types::TypeInfo* getCollectType(unsigned index) const final;

protected:
    /** The signature, perhaps without names and descriptions of arguments. */
    virtual OperationSignature types() const { return signature(); }
    // They throw one of the FactoryExceptions.
    static void checkCount(std::size_t wanted, std::size_t received);
    /** The arguments of a call, converted to the types of the signature. */
    Args checkedArguments(const Args& args) const;
    /** Checks the arguments that collect a call: its handle (if the first of them `isHandle`), and the variables for
        what is collected, or none. */
    void checkCollected(const Args& args, bool isHandle) const;
};

}  // namespace internal
}  // namespace RTT

#endif
