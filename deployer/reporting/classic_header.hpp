// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The head of a NetCDF file in the format CDF-5 ("64-bit data"). After it come the records, each as long as all
// variables together; numbers are big-endian. See "The NetCDF Classic Format Specification".
#ifndef ORO_OCL_REPORTING_CLASSIC_HEADER_HPP
#define ORO_OCL_REPORTING_CLASSIC_HEADER_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace OCL::reporting {

/** The numbers are those of the format. */
enum class ClassicType : std::uint32_t {
    Byte = 1,
    Char = 2,
    Short = 3,
    Int = 4,
    Float = 5,
    Double = 6,
    UByte = 7,
    UShort = 8,
    UInt = 9,
    Int64 = 10,
    UInt64 = 11
};

std::size_t sizeOf(ClassicType type);
/** Appends the number as that type, big-endian; not for Float and Double. */
void appendBig(std::string& bytes, ClassicType type, std::uint64_t number);
/** The value for what is missing: that of the format, but for Char, which has 0. */
std::string fillOf(ClassicType type);

struct ClassicAttribute {
    std::string name;
    ClassicType type = ClassicType::Char;
    std::string values;  ///< as in the file

    static ClassicAttribute text(std::string name, std::string value) {
        return {std::move(name), ClassicType::Char, std::move(value)};
    }
};

struct ClassicVariable {
    std::string name;
    ClassicType type = ClassicType::Double;
    std::string dimension;     ///< besides time; empty for one value per record
    std::size_t elements = 1;  ///< of that dimension
    std::vector<ClassicAttribute> attributes;

    /** What it takes in a record, with its padding. */
    std::size_t bytes() const { return (elements * sizeOf(type) + 3) / 4 * 4; }
};

/** Where the number of records stands in a file, in 8 bytes. */
constexpr std::size_t kRecordCountPlace = 4;

/** The head of a file without records. All variables have the unlimited dimension "time". */
std::string classicHeader(const std::vector<ClassicVariable>& variables,
                          const std::vector<ClassicAttribute>& attributes);

}  // namespace OCL::reporting

#endif
