// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Vectors of numbers as messages std_msgs/…MultiArray, for publishers and subscribers of roscpp.
#ifndef STD_MSGS_VECTOR_MULTI_ARRAY_ADAPTER_H
#define STD_MSGS_VECTOR_MULTI_ARRAY_ADAPTER_H

#include <ros/serialization.h>
#include <std_msgs/Float32MultiArray.h>
#include <std_msgs/Float64MultiArray.h>
#include <std_msgs/Int16MultiArray.h>
#include <std_msgs/Int32MultiArray.h>
#include <std_msgs/Int64MultiArray.h>
#include <std_msgs/Int8MultiArray.h>
#include <std_msgs/UInt16MultiArray.h>
#include <std_msgs/UInt32MultiArray.h>
#include <std_msgs/UInt64MultiArray.h>
#include <std_msgs/UInt8MultiArray.h>

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace std_msgs {

/** The message for vectors of T, one of the ten types of numbers: MultiArrayOf<double>::Message<Alloc>. */
template <class T>
struct MultiArrayOf;
#define ORO_MULTI_ARRAY_OF(T, NAME)         \
    template <>                             \
    struct MultiArrayOf<T> {                \
        template <class Alloc>              \
        using Message = NAME##MultiArray_<Alloc>; \
    };
ORO_MULTI_ARRAY_OF(std::int8_t, Int8)
ORO_MULTI_ARRAY_OF(std::uint8_t, UInt8)
ORO_MULTI_ARRAY_OF(std::int16_t, Int16)
ORO_MULTI_ARRAY_OF(std::uint16_t, UInt16)
ORO_MULTI_ARRAY_OF(std::int32_t, Int32)
ORO_MULTI_ARRAY_OF(std::uint32_t, UInt32)
ORO_MULTI_ARRAY_OF(std::int64_t, Int64)
ORO_MULTI_ARRAY_OF(std::uint64_t, UInt64)
ORO_MULTI_ARRAY_OF(float, Float32)
ORO_MULTI_ARRAY_OF(double, Float64)
#undef ORO_MULTI_ARRAY_OF

/**
 * A vector that is a message: one dimension without a label, as large as the vector, with the stride that the message
 * defines, its size. Dimensions of messages that are read are ignored. As thread-safe as a vector.
 */
template <class T, class Alloc = std::allocator<void>>
struct VectorMultiArrayAdapter {
    typedef typename MultiArrayOf<T>::template Message<Alloc> Message;

    VectorMultiArrayAdapter() = default;
    VectorMultiArrayAdapter(std::vector<T> elements) : data(std::move(elements)) {}
    operator const std::vector<T>&() const { return data; }

    std::vector<T> data;
};

}  // namespace std_msgs

namespace ros {
namespace message_traits {

template <class T, class Alloc>
struct IsMessage<std_msgs::VectorMultiArrayAdapter<T, Alloc>> : TrueType {};
template <class T, class Alloc>
struct MD5Sum<std_msgs::VectorMultiArrayAdapter<T, Alloc>>
    : MD5Sum<typename std_msgs::VectorMultiArrayAdapter<T, Alloc>::Message> {
    static const char* value() { return MD5Sum<typename std_msgs::VectorMultiArrayAdapter<T, Alloc>::Message>::value(); }
    static const char* value(const std_msgs::VectorMultiArrayAdapter<T, Alloc>&) { return value(); }
};
template <class T, class Alloc>
struct DataType<std_msgs::VectorMultiArrayAdapter<T, Alloc>> {
    static const char* value() {
        return DataType<typename std_msgs::VectorMultiArrayAdapter<T, Alloc>::Message>::value();
    }
    static const char* value(const std_msgs::VectorMultiArrayAdapter<T, Alloc>&) { return value(); }
};
template <class T, class Alloc>
struct Definition<std_msgs::VectorMultiArrayAdapter<T, Alloc>> {
    static const char* value() {
        return Definition<typename std_msgs::VectorMultiArrayAdapter<T, Alloc>::Message>::value();
    }
    static const char* value(const std_msgs::VectorMultiArrayAdapter<T, Alloc>&) { return value(); }
};

}  // namespace message_traits

namespace serialization {

template <class T, class Alloc>
struct Serializer<std_msgs::VectorMultiArrayAdapter<T, Alloc>> {
    typedef std_msgs::VectorMultiArrayAdapter<T, Alloc> Adapter;

    template <class Stream>
    static void write(Stream& stream, const Adapter& adapter) {
        const auto size = static_cast<std::uint32_t>(adapter.data.size());
        stream.next(std::uint32_t(1));  // dimensions
        stream.next(std::uint32_t(0));  // letters of the label
        stream.next(size);
        stream.next(size);              // stride
        stream.next(std::uint32_t(0));  // offset
        stream.next(adapter.data);
    }
    template <class Stream>
    static void read(Stream& stream, Adapter& adapter) {
        std_msgs::MultiArrayLayout_<Alloc> ignored;
        stream.next(ignored);
        stream.next(adapter.data);
    }
    static std::uint32_t serializedLength(const Adapter& adapter) {
        return 5 * 4 + serializationLength(adapter.data);
    }
};

}  // namespace serialization
}  // namespace ros

#endif
