// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_TOOL_NETCDF_WRITER_HPP
#define OROFORGE_MCAP_TOOL_NETCDF_WRITER_HPP

#include "new_file.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace oroforge::mcap {

/** Numbers of NetCDF's types. */
enum class NetcdfType : std::uint32_t { Byte = 1, Char, Short, Int, Float, Double, UByte, UShort, UInt, Int64, UInt64 };
std::size_t sizeOf(NetcdfType type);

/** A variable with a row for each index of its first dimension. */
struct NetcdfVariable {
    std::string name;
    NetcdfType type = NetcdfType::Double;
    std::vector<std::size_t> dimensions;  ///< indexes
    std::vector<std::pair<std::string, std::string>> texts;
    Bytes fill;  ///< of an element, as in the file; empty if it has no fill value
};

/** Writes a NetCDF file in the format CDF-5 ("64-bit data"): its size is known before its data come. The format is
    simple enough that the library is not needed. Errors are texts, empty if there are none. */
class NetcdfWriter {
public:
    explicit NetcdfWriter(NewFile& file) : file_(file) {}

    std::size_t addDimension(const std::string& name, std::uint64_t length);
    std::size_t addVariable(NetcdfVariable variable);
    /** All dimensions and variables are there. Writes what is before the data. */
    std::string begin();
    /** Appends the next row of a variable, as big endian: one value for each index of its other dimensions. */
    std::string append(std::size_t variable, const Bytes& row);
    /** Writes what waits in memory. */
    std::string finish();

private:
    struct Variable {
        NetcdfVariable its;
        std::uint64_t size = 0, begin = 0, written = 0;
        Bytes waiting;
    };
    Bytes head() const;
    std::string flush(Variable& variable);

    NewFile& file_;
    std::vector<std::pair<std::string, std::uint64_t>> dimensions_;
    std::vector<Variable> variables_;
};

/** Appends a number as big endian. */
template <class Number>
void putBig(Bytes& out, Number number) {
    for (std::size_t i = sizeof number; i-- > 0;)
        out.push_back(static_cast<unsigned char>(static_cast<std::uint64_t>(number) >> (8 * i)));
}

}  // namespace oroforge::mcap

#endif
