// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_MQUEUE_MESSAGE_ARCHIVE_HPP
#define ORO_MQUEUE_MESSAGE_ARCHIVE_HPP

#include <rtt/rtt-config.h>

#include <boost/archive/basic_archive.hpp>
#include <boost/mpl/bool.hpp>
#include <boost/serialization/array_wrapper.hpp>
#include <boost/serialization/collection_size_type.hpp>
#include <boost/serialization/item_version_type.hpp>
#include <boost/serialization/nvp.hpp>
#include <boost/serialization/serialization.hpp>
#include <boost/serialization/version.hpp>

#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace RTT {
namespace mqueue {

/**
 * What both archives share. Numbers are their memory, containers their number of elements in 8 bytes and then the
 * elements; there is neither padding nor a header. `Derived` transfers bytes and counts.
 */
template <class Derived>
class MessageArchive {
public:
    unsigned int get_library_version() const { return 0; }
    template <class T>
    void register_type(const T* = nullptr) {}

protected:
    Derived& self() { return static_cast<Derived&>(*this); }

    template <class T>
    void pass(T& value) {
        if constexpr (std::is_same<T, bool>::value)
            self().boolean(value);
        else if constexpr (std::is_arithmetic<T>::value || std::is_enum<T>::value)
            self().bytes(&value, sizeof value);
        else
            boost::serialization::serialize_adl(self(), value,
                                                static_cast<unsigned>(boost::serialization::version<T>::value));
    }
    template <class T>
    void pass(const boost::serialization::nvp<T>& pair) {
        self().pass(pair.value());
    }
    template <class T>
    void pass(const boost::serialization::array_wrapper<T>& array) {
        for (std::size_t i = 0; i != array.count(); ++i) self().pass(const_cast<T&>(array.address()[i]));
    }
    template <class T, std::size_t N>
    void pass(T (&array)[N]) {
        for (T& element : array) self().pass(element);
    }
    template <class T, class Allocator>
    void pass(std::vector<T, Allocator>& elements) {
        self().count(elements);
        if constexpr (std::is_same<T, bool>::value) {
            for (std::size_t i = 0; i != elements.size(); ++i) {
                bool element = elements[i];
                self().boolean(element);
                if constexpr (Derived::is_loading::value) elements[i] = element;
            }
        } else if constexpr (std::is_arithmetic<T>::value) {
            self().bytes(elements.data(), elements.size() * sizeof(T));
        } else {
            for (T& element : elements) self().pass(element);
        }
    }
    void pass(std::string& text) {
        self().count(text);
        self().bytes(&text[0], text.size());
    }
    void pass(boost::serialization::collection_size_type& number) {
        std::size_t count = number;
        self().bytes(&count, sizeof count);
        number = boost::serialization::collection_size_type(count);
    }
    // Versions are not in the message.
    void pass(boost::serialization::item_version_type&) {}
    void pass(boost::archive::version_type&) {}
    void pass(boost::archive::tracking_type&) {}
};

/** Writes into a buffer, or only counts. */
class MessageWriter : public MessageArchive<MessageWriter> {
public:
    typedef boost::mpl::bool_<true> is_saving;
    typedef boost::mpl::bool_<false> is_loading;

    /** Counts. */
    MessageWriter() = default;
    MessageWriter(void* to, std::size_t room) : to_(static_cast<char*>(to)), room_(room) {}

    std::size_t size() const { return size_; }
    bool fits() const { return !to_ || size_ <= room_; }

    template <class T>
    MessageWriter& operator<<(const T& value) {
        pass(const_cast<T&>(value));
        return *this;
    }
    template <class T>
    MessageWriter& operator&(const T& value) {
        return *this << value;
    }
    void save_binary(const void* from, std::size_t size) { bytes(from, size); }

private:
    friend class MessageArchive<MessageWriter>;
    void boolean(bool value) {
        const unsigned char byte = value ? 1 : 0;
        bytes(&byte, 1);
    }
    void bytes(const void* from, std::size_t size) {
        if (to_ && size != 0 && size_ <= room_ && size <= room_ - size_) std::memcpy(to_ + size_, from, size);
        size_ += size;
    }
    template <class Container>
    void count(const Container& elements) {
        const std::size_t count = elements.size();
        bytes(&count, sizeof count);
    }

    char* const to_ = nullptr;
    const std::size_t room_ = 0;
    std::size_t size_ = 0;
};

/** Reads from a buffer. Throws std::runtime_error at its end. */
class MessageReader : public MessageArchive<MessageReader> {
public:
    typedef boost::mpl::bool_<false> is_saving;
    typedef boost::mpl::bool_<true> is_loading;

    MessageReader(const void* from, std::size_t size) : from_(static_cast<const char*>(from)), left_(size) {}

    std::size_t left() const { return left_; }

    template <class T>
    MessageReader& operator>>(T& value) {
        pass(value);
        return *this;
    }
    template <class T>
    MessageReader& operator>>(const T& wrapper) {
        pass(wrapper);
        return *this;
    }
    template <class T>
    MessageReader& operator&(T& value) {
        return *this >> value;
    }
    template <class T>
    MessageReader& operator&(const T& wrapper) {
        return *this >> wrapper;
    }
    void load_binary(void* to, std::size_t size) { bytes(to, size); }
    void reset_object_address(const void*, const void*) {}
    void delete_created_pointers() {}

private:
    friend class MessageArchive<MessageReader>;
    /** Any byte but 0 is true. */
    void boolean(bool& value) {
        unsigned char byte = 0;
        bytes(&byte, 1);
        value = byte != 0;
    }
    void bytes(void* to, std::size_t size) {
        if (size > left_) throw std::runtime_error("it ends too early");
        if (size != 0) std::memcpy(to, from_, size);
        from_ += size;
        left_ -= size;
    }
    template <class Container>
    void count(Container& elements) {
        std::size_t count = 0;
        bytes(&count, sizeof count);
        if (count > left_) throw std::runtime_error("it has a container of more elements than bytes");
        elements.resize(count);
    }

    const char* from_;
    std::size_t left_;
};

}  // namespace mqueue
}  // namespace RTT

#endif
