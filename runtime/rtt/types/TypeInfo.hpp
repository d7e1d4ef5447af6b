// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TYPE_INFO_HPP
#define ORO_TYPE_INFO_HPP

#include <rtt/base/DataSourceBase.hpp>
#include <boost/shared_ptr.hpp>
#include <memory>
#include <string>
#include <type_traits>
#include <typeinfo>
#include <vector>

namespace RTT {

class ConnPolicy;
namespace base {
class AttributeBase;
class PropertyBase;
class InputPortInterface;
class OutputPortInterface;
class ChannelElementBase;
}  // namespace base
namespace internal {
class ConnFactory;
class Reference;
}  // namespace internal

namespace types {

struct Shape;
struct TypeOps;
struct TypeThunks;
class TypeConstructor;
class TypeTransporter;
class ValueFactory;
class MemberFactory;
class CompositionFactory;
class CompositionHooks;
class StreamFactory;

typedef boost::shared_ptr<ValueFactory> ValueFactoryPtr;
typedef boost::shared_ptr<MemberFactory> MemberFactoryPtr;
typedef boost::shared_ptr<CompositionFactory> CompositionFactoryPtr;
typedef boost::shared_ptr<StreamFactory> StreamFactoryPtr;
typedef boost::shared_ptr<internal::ConnFactory> ConnFactoryPtr;

namespace detail {
/** A factory that calls `hooks`. */
RTT_API CompositionFactoryPtr compositionBy(const boost::shared_ptr<CompositionHooks>& hooks);
}  // namespace detail

/**
 * The run-time information about a C++ type: names, factories of values, variables, properties and ports, members, text
 * form, conversions and transports. What a type lacks yields null, false or an empty list, never an error. Objects live
 * until the process ends.
 *
 * Thread safe. Not for real-time contexts.
 */
class RTT_API TypeInfo {
public:
    typedef const std::type_info* TypeId;
    typedef base::DataSourceBase::shared_ptr SourcePtr;

    explicit TypeInfo(std::string name, TypeId id = nullptr);
    TypeInfo(const TypeInfo&) = delete;
    TypeInfo& operator=(const TypeInfo&) = delete;
    ~TypeInfo();

    /** The name under which it was first registered. */
    const std::string& getTypeName() const;
    /** All names. */
    std::vector<std::string> getTypeNames() const;
    /** Adds a name, which TypeInfoRepository::type() finds, too. False if this or another type has the name already. */
    bool addAlias(const std::string& alias);
    bool isType(const std::string& name) const;
    bool setTypeId(TypeId id);
    TypeId getTypeId() const;
    /** type_info::name() of the C++ type, which is its identity in all registries; "" if unknown. */
    const char* getTypeIdName() const;
    /** The description of the type, from the comment in its header. */
    const std::string& getDescription() const;
    void setDescription(const std::string& text);

    // -- Values ---------------------------------------------------------------------------------------------
    /** A value made from arguments by a constructor. Without arguments it is a default value; one of this type is
        returned. */
    SourcePtr construct(const std::vector<SourcePtr>& arguments) const;
    /** `source` converted to this type; `source` itself if it has this type or if there is no conversion. */
    SourcePtr convert(SourcePtr source) const;
    /** Takes ownership. */
    void addConstructor(TypeConstructor* constructor);

    SourcePtr buildValue() const;
    /** A source on memory that holds such a value. */
    SourcePtr buildReference(void* value) const;
    SourcePtr buildActionAlias(base::ActionInterface* action, SourcePtr source) const;
    base::AttributeBase* buildConstant(std::string name, SourcePtr value, int sizehint) const;
    base::AttributeBase* buildConstant(std::string name, SourcePtr value) const;
    /** Containers and strings get `sizehint` elements, strings zero letters; other types ignore it. */
    base::AttributeBase* buildVariable(std::string name, int sizehint) const;
    base::AttributeBase* buildVariable(std::string name) const;
    base::AttributeBase* buildAttribute(std::string name, SourcePtr source = nullptr) const;
    base::AttributeBase* buildAlias(std::string name, SourcePtr source) const;
    base::PropertyBase* buildProperty(const std::string& name, const std::string& description,
                                      SourcePtr source = nullptr) const;

    // -- Text -----------------------------------------------------------------------------------------------
    /** "(typename)" for types without a text form. */
    std::ostream& write(std::ostream& os, SourcePtr source) const;
    std::istream& read(std::istream& is, SourcePtr target) const;
    std::string toString(SourcePtr source) const;
    bool fromString(const std::string& text, SourcePtr target) const;
    bool isStreamable() const;

    // -- Members --------------------------------------------------------------------------------------------
    bool resize(SourcePtr source, int size) const;
    std::vector<std::string> getMemberNames() const;
    /** Live part of `item`; null if there is no such member. */
    SourcePtr getMember(SourcePtr item, const std::string& name) const;
    SourcePtr getMember(SourcePtr item, SourcePtr id) const;
    /** Makes `reference` refer to that member; false if there is none. */
    bool getMember(internal::Reference* reference, SourcePtr item, const std::string& name) const;

    /** What its values consist of. A type without a shape has the reason in it. Allocates. */
    Shape shape() const;

    // -- Decomposition --------------------------------------------------------------------------------------
    /** Sets `target`, of this type, from a value of this type, a bag of its members, or another form it knows. */
    bool composeType(SourcePtr source, SourcePtr target) const;
    /** A simpler form of the value: a bag of members, a number, a text; null if it has none. */
    SourcePtr decomposeType(SourcePtr source) const;
    /** Sets `target` from `source`, converted if needed; false if there is no conversion. */
    bool convertType(SourcePtr source, SourcePtr target) const;
    /** A compatible value of a more common type, such as an int for a short; `source` itself if there is none. */
    SourcePtr convertType(SourcePtr source) const;

    // -- Ports ----------------------------------------------------------------------------------------------
    base::InputPortInterface* inputPort(const std::string& name) const;
    base::OutputPortInterface* outputPort(const std::string& name) const;
    boost::intrusive_ptr<base::ChannelElementBase> buildDataStorage(const ConnPolicy& policy) const;
    boost::intrusive_ptr<base::ChannelElementBase> buildChannelOutput(base::InputPortInterface& port,
                                                                      const ConnPolicy& policy) const;
    boost::intrusive_ptr<base::ChannelElementBase> buildChannelInput(base::OutputPortInterface& port,
                                                                     const ConnPolicy& policy) const;

    // -- Transports -----------------------------------------------------------------------------------------
    /** Takes ownership, even if it returns false because there is a transporter for that protocol already. One that is
        not generic replaces a generic one. */
    bool addProtocol(int protocol, TypeTransporter* transporter);
    /** The transporter of this type, or of unknown_t if it has none. Logs a warning and returns null if neither has
        one. This and hasProtocol() load the toolchain's own transport for that protocol, if nobody has yet. */
    TypeTransporter* getProtocol(int protocol) const;
    bool hasProtocol(int protocol) const;
    std::vector<int> getTransportNames() const;

    // -- For typekits ---------------------------------------------------------------------------------------
    void setOps(const TypeOps* ops);
    const TypeOps* getOps() const;
    void setThunks(const TypeThunks* thunks);
    const TypeThunks* getThunks() const;
    /** For views on arrays: sets their element type. */
    void setArrayElement(const char* elementIdName);
    const char* getArrayElement() const;

    void setValueFactory(ValueFactoryPtr factory);
    void setMemberFactory(MemberFactoryPtr factory);
    void setCompositionFactory(CompositionFactoryPtr factory);
    /** For a generator that is not a factory: uses its overrides of CompositionHooks. */
    template <class Generator, class = std::enable_if_t<std::is_base_of<CompositionHooks, Generator>::value &&
                                                        !std::is_convertible<Generator*, CompositionFactory*>::value>>
    void setCompositionFactory(const boost::shared_ptr<Generator>& self) {
        setCompositionFactory(detail::compositionBy(self));
    }
    void setStreamFactory(StreamFactoryPtr factory);
    void setPortFactory(ConnFactoryPtr factory);
    ValueFactoryPtr getValueFactory() const;
    MemberFactoryPtr getMemberFactory() const;
    CompositionFactoryPtr getCompositionFactory() const;
    StreamFactoryPtr getStreamFactory() const;
    ConnFactoryPtr getPortFactory() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace types
}  // namespace RTT

#endif
