// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Finds the members of a struct by running its boost::serialization function on an archive that only records them. This
// is the only header that includes boost::serialization.
#ifndef ORO_MEMBER_DISCOVERY_HPP
#define ORO_MEMBER_DISCOVERY_HPP

#include "StructTable.hpp"
#include <boost/array.hpp>
#include <boost/mpl/bool.hpp>
#include <boost/serialization/array.hpp>
#include <boost/serialization/nvp.hpp>
#include <boost/serialization/serialization.hpp>
#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace RTT {
namespace types {
namespace detail {

/** A table of members that is made at run time and kept until the process ends, like tables in generated code. */
class DiscoveredMembers {
public:
    explicit DiscoveredMembers(std::size_t objectSize) : objectSize_(objectSize) {}

    /** Members outside the object (temporaries of the serialization function) have no fixed place and are left out. */
    void add(const char* name, std::ptrdiff_t offset, TypeRef type, std::size_t count, TypeRef whole = nullptr) {
        if (offset < 0 || static_cast<std::size_t>(offset) >= objectSize_) return leaveOut();
        names_.emplace_back(name);
        members_.push_back({names_.back().c_str(), static_cast<std::size_t>(offset), type, count, "", "", whole});
    }
    /** The serialization function has a value that is no member of the table. */
    void leaveOut() { isComplete_ = false; }
    bool isComplete() const { return isComplete_; }
    const Member* table() const { return members_.data(); }
    std::size_t size() const { return members_.size(); }

private:
    std::size_t objectSize_;
    bool isComplete_ = true;
    std::deque<std::string> names_;  // a deque never moves its strings
    std::vector<Member> members_;
};

/** Looks like an archive that loads an Object. */
template <class Object>
class NotingArchive {
public:
    typedef boost::mpl::bool_<true> is_loading;
    typedef boost::mpl::bool_<false> is_saving;

    NotingArchive(DiscoveredMembers& found, const Object& object) : found_(found), object_(std::addressof(object)) {}

    template <class T>
    void register_type(const T* = nullptr) {}
    unsigned int get_library_version() const { return 0; }
    void reset_object_address(const void*, const void*) {}

    template <class T>
    NotingArchive& operator&(const boost::serialization::nvp<T>& pair) {
        note(pair.name(), pair.value());
        return *this;
    }
    template <class T>
    NotingArchive& operator>>(const boost::serialization::nvp<T>& pair) {
        return *this & pair;
    }
    template <class T>
    NotingArchive& operator<<(const boost::serialization::nvp<T>& pair) {
        return *this & pair;
    }
    /** A value without a name cannot be a member; members of a base class are members of the object. */
    template <class T>
    NotingArchive& operator&(const T& value) {
        if constexpr (std::is_base_of_v<T, Object> && !std::is_same_v<T, Object>)
            boost::serialization::serialize_adl(*this, const_cast<T&>(value), 0u);
        else
            found_.leaveOut();
        return *this;
    }
    template <class T>
    NotingArchive& operator>>(const T& value) {
        return *this & value;
    }
    template <class T>
    NotingArchive& operator<<(const T& value) {
        return *this & value;
    }

private:
    std::ptrdiff_t offsetOf(const void* member) const {
        return static_cast<const char*>(member) - static_cast<const char*>(object_);
    }
    template <class T>
    void note(const char* name, const T& member) {
        found_.add(name, offsetOf(std::addressof(member)), &typeRef<std::remove_cv_t<T>>, 0);
    }
    template <class E, std::size_t N>
    void note(const char* name, const E (&member)[N]) {
        noteArray(name, &member[0], N);
    }
    template <class E>
    void note(const char* name, const boost::serialization::array_wrapper<E>& wrapper) {
        noteArray(name, wrapper.address(), wrapper.count());
    }
    template <class E, std::size_t N>
    void note(const char* name, const boost::array<E, N>& member) {
        noteArray(name, member.data(), N, &typeRef<boost::array<E, N>>);
    }
    template <class E, std::size_t N>
    void note(const char* name, const std::array<E, N>& member) {
        noteArray(name, member.data(), N, &typeRef<std::array<E, N>>);
    }
    template <class E>
    void noteArray(const char* name, const E* first, std::size_t count, TypeRef whole = nullptr) {
        using Element = std::remove_cv_t<std::remove_all_extents_t<E>>;
        found_.add(name, offsetOf(first), &typeRef<Element>, count * sizeof(E) / sizeof(Element), whole);
    }

    DiscoveredMembers& found_;
    const void* object_;
};

/** Runs T's serialization function once; the same table each time. */
template <class T>
const DiscoveredMembers* discoverMembers() {
    static const DiscoveredMembers* const members = [] {
        auto* found = new DiscoveredMembers(sizeof(T));
        const auto object = std::make_unique<T>();
        NotingArchive<T> archive(*found, *object);
        boost::serialization::serialize_adl(archive, *object, 0u);
        return found;
    }();
    return members;
}

}  // namespace detail
}  // namespace types
}  // namespace RTT

#endif
