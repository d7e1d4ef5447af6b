// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What the generated <NAME/typekit/Types.hpp> needs of the runtime. The templates that component authors use with a
// type are declared for users, and instantiated once, in the typekit. A user links the typekit's library.
#ifndef ORO_TYPEKIT_USER_HPP
#define ORO_TYPEKIT_USER_HPP

#include "../Attribute.hpp"
#include "../InputPort.hpp"
#include "../OutputPort.hpp"
#include "../Property.hpp"
#include "../base/ChannelElement.hpp"
#include "../internal/DataSources.hpp"

// HOW: `template class`, or `extern template class`. The compiler decides where an instance is first made whether it is
// visible, so classes that others are made of come first.
#define ORO_VALUE_TEMPLATES(HOW, ...)                     \
    HOW RTT::internal::DataSource<__VA_ARGS__>;           \
    HOW RTT::internal::AssignableDataSource<__VA_ARGS__>; \
    HOW RTT::Property<__VA_ARGS__>;                       \
    HOW RTT::Attribute<__VA_ARGS__>;                      \
    HOW RTT::internal::ValueDataSource<__VA_ARGS__>;      \
    HOW RTT::internal::ConstantDataSource<__VA_ARGS__>;   \
    HOW RTT::internal::ReferenceDataSource<__VA_ARGS__>;
#define ORO_PORT_TEMPLATES(HOW, ...)  \
    HOW RTT::OutputPort<__VA_ARGS__>; \
    HOW RTT::InputPort<__VA_ARGS__>;  \
    HOW RTT::base::ChannelElement<__VA_ARGS__>;

/** Of a type that has no default value, or cannot be assigned, there are no ports. */
#define ORO_DECLARE_VALUE(...) ORO_VALUE_TEMPLATES(extern template class RTT_EXPORT, __VA_ARGS__)
#define ORO_DECLARE_SAMPLE(...)    \
    ORO_DECLARE_VALUE(__VA_ARGS__) \
    ORO_PORT_TEMPLATES(extern template class RTT_EXPORT, __VA_ARGS__)

/** The instances themselves. */
#define ORO_MAKE_VALUE(...) ORO_VALUE_TEMPLATES(template class, __VA_ARGS__)
#define ORO_MAKE_SAMPLE(...)    \
    ORO_MAKE_VALUE(__VA_ARGS__) \
    ORO_PORT_TEMPLATES(template class, __VA_ARGS__)

#endif
